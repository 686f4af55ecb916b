#include "fusee/effects/effect.h"

namespace fusee::effects {

Effect make_joint_viscous() {
    return {.id = "joint.viscous",
            .law = "Extra viscous drag at the joint.",
            .meaning = "The joint friction grows with speed.",
            .sided = false,
            .parameters = {{"d", "Nms", 0.04, {0, 0.5}, 0}},
            .starts = {0.5, 1.5},
            .seen_by = {Experiment::kDeadBand, Experiment::kJointStiffness, Experiment::kCocontraction, Experiment::kLog},
            .confused_with = {"joint.coulomb", "gear.viscous"},
            .advice = "check grease and seals of the joint; the corrected profile includes this friction",
            .apply = [](BuiltRig& rig, int, std::span<const double> values) { rig.joint_viscous += values[0]; }};
}

}  // namespace fusee::effects
