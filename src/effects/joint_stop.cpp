#include "fusee/effects/effect.h"

namespace fusee::effects {

Effect make_joint_stop() {
    return {.id = "joint.stop",
            .law = "A hard stop inside the modelled range limits |q|.",
            .meaning = "The joint meets a hard stop at this angle, inside the modelled range.",
            .sided = false,
            .parameters = {{"q_s", "rad", 0.5, {0.02, 4}, 0},
                           {"k_s", "Nm/rad", 50, {3, 500}, 60, {15, 60, 250}},
                           {"zeta", "1", 0.3, {0, 2}, 0.5}},
            .starts = {0.3, 0.6, 1, 1.5, 2.2, 3},
            .seen_by = {Experiment::kDeadBand, Experiment::kJointStiffness, Experiment::kLog},
            .confused_with = {},
            .advice = "find the obstacle that the joint meets and remove it",
            .apply = [](BuiltRig& rig, int, std::span<const double> values) {
                rig.stop = values[0];
                rig.stop_stiffness = values[1];
                rig.stop_damping = values[2];
            }};
}

}  // namespace fusee::effects
