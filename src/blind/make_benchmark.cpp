#include <fmt/format.h>

#include "engine_case.h"
#include "fusee/blind/blind.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/folder.h"
#include "fusee/plant/case_files.h"
#include "model_case.h"
#include "side_by_side.h"

namespace fusee::blind {

namespace {

/// A benchmark depends only on these values.
core::OutputRun run_of(const BenchmarkOptions& options) {
    const std::string figures = fmt::format("seed-{}-cases-{}{}{}", options.seed, options.cases,
                                            options.maker == Maker::kPlant ? "" : "-" + to_string(options.maker),
                                            options.family == Family::kFormBlind ? "-form-blind" : "");
    return {.command = "blind make", .source = options.out / figures, .force = options.force, .files = {"labels.sealed", "seal.txt"}};
}

void write_plant_case(const std::filesystem::path& folder, std::uint64_t seed, std::size_t index, const std::vector<LabelEffect>& labels) {
    std::vector<plant::Effect> effects;
    for (const LabelEffect& e : labels) effects.push_back({e.id, e.side, e.size, e.extra});
    core::make_folder(folder / "heldout");
    for (const auto& [name, bytes] : plant::make_case(seed, index, effects)) core::write_file(folder / name, bytes);
}

/// The model takes set points, pushes and nominal figures from a faultless case of the plant.
void write_case(const std::filesystem::path& out, const BenchmarkOptions& options, std::size_t index, const Label& label) {
    const std::filesystem::path folder = out / label.case_name;
    if (options.maker == Maker::kPlant) return write_plant_case(folder, options.seed, index, label.effects);
    if (is_engine(options.maker)) return write_engine_case(options.maker, folder, options.seed, index, label);
    write_plant_case(folder, options.seed, index, {});
    measure_by_model(folder, options.seed, index, label);
}

/// The model cannot measure effects that it does not have.
Mix mix_of(const BenchmarkOptions& options) {
    Mix mix = options.mix;
    if (options.maker == Maker::kModel) mix.outside = 0.0;
    return mix;
}

Family family_of(const BenchmarkOptions& options) {
    return is_engine(options.maker) && options.family == Family::kUsual ? Family::kEngine : options.family;
}

}  // namespace

std::string make_benchmark(const BenchmarkOptions& options) {
    if (options.out.empty()) throw core::InvalidInput("out", "\"\"", "the name of a folder");
    if (options.family == Family::kFormBlind && options.maker == Maker::kModel)
        throw core::InvalidInput("family", "form-blind", "the plant's measurements: the model has none of these effects");
    if (is_engine(options.maker)) (void)engine_program(options.maker);
    core::OutputFolder output(options.out, run_of(options));
    const std::vector<Label> labels = draw_labels(options.seed, options.cases, mix_of(options), family_of(options));
    const std::string sealed = seal_labels(labels, options.seed);
    std::string hash = core::sha256_hex(sealed);
    const std::filesystem::path out = output.path();
    core::write_file(out / "labels.sealed", sealed);
    core::write_file(out / "seal.txt", "sha256:" + hash + "\n");
    if (options.progress) options.progress(0, labels.size(), "seal sha256:" + hash);
    side_by_side(
        labels.size(), options.jobs, [&](std::size_t i) { write_case(out, options, i, labels[i]); },
        [&](std::size_t done, std::size_t i) {
            if (options.progress) options.progress(done, labels.size(), labels[i].case_name);
        });
    output.commit();
    return hash;
}

}  // namespace fusee::blind
