#include "model_case.h"

#include <cmath>

#include "faultless.h"
#include "fusee/diagnosis/diagnose.h"
#include "fusee/effects/effect.h"
#include "fusee/plant/rig.h"

namespace fusee::blind {

namespace {

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

}  // namespace

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

}  // namespace fusee::blind
