#include "model_case.h"

#include <cmath>

#include "faultless.h"
#include "fusee/gap/diagnose.h"
#include "fusee/gap/effect.h"
#include "fusee/plant/random.h"

namespace fusee::blind {

namespace {

/// Streams of a case that the model makes: none of those that the plant draws from.
enum Purpose : std::uint64_t { kBuild = 111, kNoise, kHeldoutNoise };

/// Further parameters stand in the same order in both; what the plant leaves out is as the model's law begins.
gap::FoundEffect model_effect(const LabelEffect& label) {
    gap::FoundEffect effect{{label.id, label.side}, 1.0, {label.size, {}, {}}, {}};
    const std::vector<gap::EffectParameter>& parameters = gap::find_effect(label.id).parameters;
    for (std::size_t i = 0; i < label.extra.size(); ++i) effect.extra.emplace_back(parameters.at(i + 1).name, label.extra[i].second);
    return effect;
}

gap::Rows read_by_sensors(const gap::Case& bench, const gap::Rows& exact, plant::Random random) {
    gap::Signals read = gap::measured(exact);
    const gap::Signals sigma = sensor_sigma(bench, exact, read);
    const gap::Sensors& s = bench.sensors;
    for (const gap::Experiment experiment : gap::kAllExperiments)
        for (std::size_t i = 0; i < read[experiment].size(); ++i) {
            double& figure = read[experiment][i];
            if (is_read_by_encoder(experiment))
                figure = std::round((figure + s.encoder_noise * random.normal()) / s.encoder_step) * s.encoder_step;
            else
                figure += sigma[experiment][i] * random.normal();
        }
    return gap::with_measured(exact, read);
}

}  // namespace

void measure_by_model(const std::filesystem::path& folder, std::uint64_t seed, std::size_t index, const Label& label) {
    const gap::Case bench = gap::read_case(folder);
    plant::Random build(seed, index, kBuild);
    Faultless rig = draw_faultless(bench, build);
    for (const LabelEffect& effect : label.effects) rig.built.effects.push_back(model_effect(effect));
    const auto measure = [&](const std::filesystem::path& where, Purpose noise) {
        const gap::Rows exact = gap::predict(rig.bench, rig.built, gap::read_inputs(bench, where));
        gap::write_rows(bench, read_by_sensors(bench, exact, plant::Random(seed, index, noise)), where);
    };
    measure(folder, kNoise);
    measure(folder / "heldout", kHeldoutNoise);
}

}  // namespace fusee::blind
