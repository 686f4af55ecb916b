#include "fusee/effects/effect.h"

namespace fusee::effects {

Effect make_sensor_joint_offset() {
    return {.id = "sensor.joint_offset",
            .law = "The zero of the joint encoder is displaced.",
            .meaning = "The zero of the joint encoder is displaced by this angle.",
            .sided = false,
            .parameters = {{"q_0", "rad", 0.05, {-1, 1}, 0}},
            .starts = {-1, 1},
            .seen_by = {Experiment::kDeadBand, Experiment::kJointStiffness, Experiment::kCocontraction, Experiment::kLog},
            .confused_with = {},
            .advice = "set the zero of the joint encoder",
            .apply = [](BuiltRig& rig, int, std::span<const double> values) { rig.joint_offset += values[0]; }};
}

}  // namespace fusee::effects
