#include <algorithm>

#include "fusee/core/error.h"
#include "fusee/gap/diagnose.h"
#include "fusee/gap/effect.h"
#include "fusee/gap/signals.h"
#include "tolerances.h"

namespace fusee::gap {

namespace {

/// The values of an effect's parameters: its size, and the further ones as found or else as they start.
std::vector<double> values_of(const Effect& effect, const FoundEffect& found) {
    std::vector<double> values{found.parameter.value};
    for (std::size_t k = 1; k < effect.parameters.size(); ++k) {
        const EffectParameter& law = effect.parameters[k];
        const auto known = std::find_if(found.extra.begin(), found.extra.end(), [&](const auto& extra) { return extra.first == law.name; });
        values.push_back(known == found.extra.end() ? law.at_first : known->second);
    }
    return values;
}

BuiltRig rig_of(const Case& nominal, const Diagnosis& found) {
    BuiltRig rig(nominal.rig);
    for (const BuildParameter& build : build_parameters(nominal)) {
        const auto known =
            std::find_if(found.build.begin(), found.build.end(), [&](const auto& entry) { return entry.first == build.name; });
        build.add(rig, known == found.build.end() ? 0.0 : known->second.value);
    }
    for (const FoundEffect& effect : found.effects) {
        const Effect& law = find_effect(effect.cause.id);
        apply_effect(law, effect.cause, values_of(law, effect), rig);
    }
    return rig;
}

}  // namespace

Rows predict(const Case& nominal, const Diagnosis& found, const Rows& inputs) {
    BuiltRig rig = rig_of(nominal, found);
    rig.assemble(NominalCams(nominal.rig));
    return with_measured(inputs, predict_signals(rig, inputs, nominal.protocol));
}

}  // namespace fusee::gap
