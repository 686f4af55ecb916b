#include "fusee/effects/effect.h"

namespace fusee::effects {

Effect make_gear_viscous() {
    return {.id = "gear.viscous",
            .law = "Extra viscous drag at the capstan.",
            .meaning = "The gear friction grows with speed, for example in stiff grease.",
            .sided = true,
            .parameters = {{"d", "Nms", 0.05, {0, 1}, 0}},
            .starts = {0.5, 1.5},
            .seen_by = {Experiment::kDeadBand, Experiment::kJointStiffness, Experiment::kCocontraction, Experiment::kLog},
            .confused_with = {"joint.viscous"},
            .advice = "move slower or change the grease; the corrected profile includes this friction",
            .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].gear.viscous += values[0]; }};
}

}  // namespace fusee::effects
