#include "fusee/effects/effect.h"

namespace fusee::effects {

Effect make_gear_backlash() {
    return {.id = "gear.backlash",
            .law = "Play between the capstan and the encoder of its motor.",
            .meaning = "The gear has this much play before its teeth meet on the other side.",
            .sided = true,
            .parameters = {{"b", "rad", 0.03, {0, 0.5}, 0}},
            .starts = {0.5, 1.5},
            .seen_by = {Experiment::kCocontraction, Experiment::kLog},
            .confused_with = {},
            .advice = "remove the play in the gear or its coupling",
            .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].gear.backlash += values[0]; }};
}

}  // namespace fusee::effects
