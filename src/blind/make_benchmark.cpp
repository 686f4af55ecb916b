#include "fusee/blind/blind.h"
#include "fusee/core/destination.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/plant/case_files.h"
#include "model_case.h"
#include "side_by_side.h"

namespace fusee::blind {

namespace {

void require_empty(const std::filesystem::path& out) {
    std::error_code none;
    const bool free =
        !std::filesystem::exists(out, none) || (std::filesystem::is_directory(out, none) && std::filesystem::is_empty(out, none));
    if (out.empty() || !free) throw core::InvalidInput("out", out.string(), "a folder that does not exist yet, or is empty");
}

void write_plant_case(const std::filesystem::path& folder, std::uint64_t seed, std::size_t index, const std::vector<LabelEffect>& labels) {
    std::vector<plant::Effect> effects;
    for (const LabelEffect& e : labels) effects.push_back({e.id, e.side, e.size, e.extra});
    core::make_folder(folder / "heldout");
    for (const auto& [name, bytes] : plant::make_case(seed, index, effects)) core::write_file(folder / name, bytes);
}

/// The model takes set points, pushes and nominal figures from a faultless case of the plant.
void write_case(const BenchmarkOptions& options, std::size_t index, const Label& label) {
    const std::filesystem::path folder = options.out / label.case_name;
    if (options.maker == Maker::kPlant) return write_plant_case(folder, options.seed, index, label.effects);
    core::StagedFolder staged(folder);
    write_plant_case(staged.path(), options.seed, index, {});
    measure_by_model(staged.path(), options.seed, index, label);
    staged.commit();
}

/// What the model does not know cannot be measured on it.
Mix mix_of(const BenchmarkOptions& options) {
    Mix mix = options.mix;
    if (options.maker == Maker::kModel) mix.outside = 0.0;
    return mix;
}

}  // namespace

std::string make_benchmark(const BenchmarkOptions& options) {
    require_empty(options.out);
    const std::vector<Label> labels = draw_labels(options.seed, options.cases, mix_of(options));
    const std::string sealed = seal_labels(labels, options.seed);
    std::string hash = core::sha256_hex(sealed);
    core::make_folder(options.out);
    core::write_file(options.out / "labels.sealed", sealed);
    core::write_file(options.out / "seal.txt", "sha256:" + hash + "\n");
    if (options.progress) options.progress(0, labels.size(), "seal sha256:" + hash);
    side_by_side(
        labels.size(), options.jobs, [&](std::size_t i) { write_case(options, i, labels[i]); },
        [&](std::size_t done, std::size_t i) {
            if (options.progress) options.progress(done, labels.size(), labels[i].case_name);
        });
    return hash;
}

}  // namespace fusee::blind
