#include "fusee/effects/effect.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "fusee/core/error.h"
#include "fusee/core/lists.h"
#include "fusee/core/text.h"

namespace fusee::effects {

EffectParameter on_rig(EffectParameter parameter, const gap_case::Reference& reference) {
    const double factor = reference.of(parameter.unit);
    for (double* value : {&parameter.scale, &parameter.allowed.low, &parameter.allowed.high, &parameter.at_first}) *value *= factor;
    for (double& value : parameter.tries) value *= factor;
    return parameter;
}

std::vector<Effect> effects_on(const gap_case::Reference& reference) {
    std::vector<Effect> all = effect_library();
    for (Effect& effect : all)
        for (EffectParameter& parameter : effect.parameters) parameter = on_rig(parameter, reference);
    return all;
}

const Effect* effect_or_none(std::string_view id) { return core::find_by(effect_library(), &Effect::id, id); }

const Effect& find_effect(const std::string& id) {
    if (const Effect* effect = effect_or_none(id)) return *effect;
    auto ids = core::each<std::string>(effect_library(), &Effect::id);
    throw core::InvalidInput("effects: id", id, fmt::format("{}{}", fmt::join(ids, ", "), core::did_you_mean(id, ids)));
}

void apply_effect(const Effect& effect, const Cause& cause, std::span<const double> values, BuiltRig& rig) {
    if (!effect.sided) {
        if (cause.side != "none") throw core::InvalidInput("effects: side of " + effect.id, cause.side, "none");
        effect.apply(rig, 0, values);
        return;
    }
    if (cause.side != "agonist" && cause.side != "antagonist" && cause.side != "both")
        throw core::InvalidInput("effects: side of " + effect.id, cause.side, "agonist, antagonist or both");
    for (const gap_case::Side side : {gap_case::Side::kAgonist, gap_case::Side::kAntagonist})
        if (cause.side == "both" || cause.side == to_string(side)) effect.apply(rig, static_cast<int>(side), values);
}

}  // namespace fusee::effects
