#include "fusee/effects/effect.h"

namespace fusee::effects {

Effect make_motor_saturation() {
    return {.id = "motor.saturation",
            .law = "The motor torque is limited.",
            .meaning = "The motor delivers at most this torque.",
            .sided = true,
            .parameters = {{"tau_max", "Nm", 0.8, {0.1, 5}, 0}},
            .starts = {0.6, 1, 1.4},
            .seen_by = {Experiment::kBreakAway, Experiment::kDeadBand, Experiment::kJointStiffness, Experiment::kCocontraction,
                        Experiment::kLog},
            .confused_with = {"sensor.torque_scale"},
            .advice = "command less torque, or use a stronger motor",
            .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].gear.saturation = values[0]; }};
}

}  // namespace fusee::effects
