#include "fusee/effects/effect.h"

namespace fusee::effects {

Effect make_joint_coulomb() {
    return {.id = "joint.coulomb",
            .law = "Constant friction at the joint.",
            .meaning = "The joint's bearing has a constant friction.",
            .sided = false,
            .parameters = {{"tau_c", "Nm", 0.07, {0, 0.6}, 0}},
            .starts = {0.4, 1.2},
            .seen_by = {Experiment::kDeadBand, Experiment::kJointStiffness, Experiment::kCocontraction, Experiment::kLog},
            .confused_with = {"cable.tension_friction", "joint.viscous"},
            .advice = "check the joint bearing: alignment, preload, seals; the corrected profile includes this friction",
            .apply = [](BuiltRig& rig, int, std::span<const double> values) { rig.joint_coulomb += values[0]; }};
}

}  // namespace fusee::effects
