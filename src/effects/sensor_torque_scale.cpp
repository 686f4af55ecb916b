#include "fusee/effects/effect.h"

namespace fusee::effects {

Effect make_sensor_torque_scale() {
    return {.id = "sensor.torque_scale",
            .law = "The torque delivered is (1 + e) times the one commanded.",
            .meaning = "The delivered torque differs from the command by this share, for example because of a wrong motor constant.",
            .sided = true,
            .parameters = {{"e", "1", 0.15, {-0.6, 1}, 0}},
            .starts = {-1, 1},
            .seen_by = {Experiment::kBreakAway, Experiment::kDeadBand, Experiment::kJointStiffness, Experiment::kCocontraction,
                        Experiment::kLog},
            .confused_with = {"gear.asymmetry"},
            .advice = "calibrate the motor torque; new cams do not help",
            .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].gear.torque_scale += values[0]; }};
}

}  // namespace fusee::effects
