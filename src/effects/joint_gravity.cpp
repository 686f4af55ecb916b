#include "fusee/effects/effect.h"

namespace fusee::effects {

Effect make_joint_gravity() {
    return {.id = "joint.gravity",
            .law = "Weight of the link: torque -m g l sin q.",
            .meaning = "The link's weight turns the joint: its centre of mass lies off the joint's axis.",
            .sided = false,
            .parameters = {{"mgl", "Nm", 0.15, {-1, 1.5}, 0}},
            .starts = {-1, 0.6, 1.5},
            .seen_by = {Experiment::kDeadBand, Experiment::kJointStiffness, Experiment::kCocontraction, Experiment::kLog},
            .confused_with = {},
            .advice = "balance the joint, or mount it so that gravity has no lever arm",
            .apply = [](BuiltRig& rig, int, std::span<const double> values) { rig.gravity += values[0]; }};
}

}  // namespace fusee::effects
