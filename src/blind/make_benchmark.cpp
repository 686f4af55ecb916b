#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>

#include "faultless.h"
#include "fusee/core/companion.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/folder.h"
#include "fusee/core/process.h"
#include "fusee/diagnosis/diagnose.h"
#include "fusee/effects/effect.h"
#include "fusee/plant/case_files.h"
#include "label_json.h"
#include "side_by_side.h"

namespace fusee::blind {

namespace {

constexpr std::chrono::seconds kMostTime{1800};  // of a case, which takes seconds in MuJoCo and a minute in Siconos

/// Does a program fusee-NAME-plant move the rig?
bool is_engine(Maker maker) { return maker == Maker::kMujoco || maker == Maker::kSiconos; }

/// This program. @pre is_engine(maker) @throws core::InvalidInput "plant" if it is not installed
std::string engine_program(Maker maker) {
    const std::string name = "fusee-" + to_string(maker) + "-plant";
    std::string program = core::companion_program(name);
    if (!program.empty()) return program;
    const bool mujoco = maker == Maker::kMujoco;
    const std::string package = mujoco ? "libmujoco-dev" : "libsiconos-kernel-dev";
    throw core::InvalidInput("plant", to_string(maker) + ": the program " + name + " is neither beside fusee nor on PATH",
                             (mujoco ? "the package fusee-mujoco; or, as root, " : "as root, ") + ("apt-get install " + package) +
                                 ", then build everything again");
}

/// A case whose rig another engine moves, held-out measurements included. Every byte follows from the arguments and the engine's version.
/// @throws core::InvalidInput "plant" with the words of the program
void write_engine_case(Maker maker, const std::filesystem::path& folder, std::uint64_t seed, std::size_t index, const Label& label) {
    const nlohmann::json order{{"seed", seed}, {"index", index}, {"folder", folder.string()}, {"effects", effects_json(label)}};
    const std::string name = engine_program(maker);
    core::Companion program({name}, "", {}, folder.string());
    std::string answer;
    if (program.ask(order.dump(), kMostTime, answer) != core::Companion::End::kAnswered || answer != "written")
        throw core::InvalidInput("plant", name + " gave no " + label.case_name + ": " + core::last_words(program.errors()),
                                 "a rig that this engine can move");
}

/// Streams of a case that the model makes: none of those that the plant draws from.
enum ModelStream : std::uint64_t { kModelBuild = 111, kModelNoise, kModelHeldOutNoise };

/// Further parameters stand in the same order in both; what the plant leaves out is as the model's law begins.
diagnosis::FoundEffect model_effect(const LabelEffect& label) {
    diagnosis::FoundEffect effect{{label.id, label.side}, 1.0, {label.size, {}, {}}, {}};
    const std::vector<effects::EffectParameter>& parameters = effects::find_effect(label.id).parameters;
    for (std::size_t i = 0; i < label.extra.size(); ++i) effect.extra.emplace_back(parameters.at(i + 1).name, label.extra[i].second);
    return effect;
}

gap_case::Rows read_by_sensors(const gap_case::Case& gap_case, const gap_case::Rows& exact, plant::Random random) {
    joint_model::Signals read = joint_model::measured(exact);
    const joint_model::Signals sigma = sensor_sigma(gap_case, exact, read);
    const gap_case::Sensors& s = gap_case.sensors;
    for (const gap_case::Experiment experiment : gap_case::kAllExperiments)
        for (std::size_t i = 0; i < read[experiment].size(); ++i) {
            double& figure = read[experiment][i];
            if (is_read_by_encoder(experiment))
                figure = std::round((figure + s.encoder_noise * random.normal()) / s.encoder_step) * s.encoder_step;
            else
                figure += sigma[experiment][i] * random.normal();
        }
    return joint_model::with_measured(exact, read);
}

/// Replaces the measurements of a case, held-out ones included, by predictions of the model for a rig with the label's effects, build
/// tolerances and sensor noise. Every byte follows from the arguments and the case.
void measure_by_model(const std::filesystem::path& folder, std::uint64_t seed, std::size_t index, const Label& label) {
    const gap_case::Case gap_case = gap_case::read_case(folder);
    plant::Random build(seed, index, kModelBuild);
    Faultless rig = draw_faultless(gap_case, build);
    for (const LabelEffect& effect : label.effects) rig.built.effects.push_back(model_effect(effect));
    const auto measure = [&](const std::filesystem::path& where, ModelStream noise) {
        const gap_case::Rows exact = diagnosis::predict(rig.gap_case, rig.built, gap_case::read_inputs(gap_case, where));
        gap_case::write_rows(gap_case, read_by_sensors(gap_case, exact, plant::Random(seed, index, noise)), where);
    };
    measure(folder, kModelNoise);
    measure(folder / "heldout", kModelHeldOutNoise);
}

/// A benchmark depends only on these values.
core::OutputRun run_of(const BenchmarkOptions& options) {
    const std::string figures = fmt::format("seed-{}-cases-{}{}{}", options.seed, options.cases,
                                            options.maker == Maker::kPlant ? "" : "-" + to_string(options.maker),
                                            options.family == Family::kFormBlind  ? "-form-blind"
                                            : options.family == Family::kDoubtful ? "-doubtful"
                                                                                  : "");
    return {.command = "blind make", .source = options.out / figures, .force = options.force, .files = {"labels.sealed", "seal.txt"}};
}

void write_plant_case(const std::filesystem::path& folder, std::uint64_t seed, std::size_t index, const Label& label) {
    std::vector<plant::Effect> effects;
    for (const LabelEffect& e : label.effects) effects.push_back({e.id, e.side, e.size, e.extra});
    core::make_folder(folder / "heldout");
    for (const auto& [name, bytes] : plant::make_case(seed, index, effects, {}, label.conditions)) core::write_file(folder / name, bytes);
}

/// The model takes set points, pushes and nominal figures from a faultless case of the plant.
void write_case(const std::filesystem::path& out, const BenchmarkOptions& options, std::size_t index, const Label& label) {
    const std::filesystem::path folder = out / label.case_name;
    if (options.maker == Maker::kPlant) return write_plant_case(folder, options.seed, index, label);
    if (is_engine(options.maker)) return write_engine_case(options.maker, folder, options.seed, index, label);
    write_plant_case(folder, options.seed, index, Label{});
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

const std::vector<std::string>& maker_names() {
    static const std::vector<std::string> names{"plant", "model", "mujoco", "siconos"};
    return names;
}

std::string make_benchmark(const BenchmarkOptions& options) {
    if (options.out.empty()) throw core::InvalidInput("out", "\"\"", "the name of a folder");
    if (options.family == Family::kFormBlind && options.maker == Maker::kModel)
        throw core::InvalidInput("family", "form-blind", "the plant's measurements: the model has none of these effects");
    if (options.family == Family::kDoubtful && options.maker != Maker::kPlant)
        throw core::InvalidInput("family", "doubtful", "the own rig, --plant plant: the others have no such conditions");
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
