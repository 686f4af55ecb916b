#include "fusee/effects/effect.h"

namespace fusee::effects {

Effect make_joint_viscous() {
    return {.id = "joint.viscous",
            .law = "Extra viscous drag at the joint.",
            .meaning = "The joint drags more the faster it turns.",
            .sided = false,
            .parameters = {{"d", "Nms", 0.04, {0, 0.5}, 0}},
            .starts = {0.5, 1.5},
            .seen_by = {Experiment::kDeadBand, Experiment::kJointStiffness, Experiment::kCocontraction, Experiment::kLog},
            .confused_with = {"joint.coulomb", "gear.viscous"},
            .advice = "look at the joint's grease and seals; the corrected profile has it in its model",
            .apply = [](BuiltRig& rig, int, std::span<const double> values) { rig.joint_viscous += values[0]; }};
}

}  // namespace fusee::effects
