#include "fusee/effects/effect.h"

namespace fusee::effects {

Effect make_gear_asymmetry() {
    return {.id = "gear.asymmetry",
            .law = "Friction is (1 + a) times the nominal value when the motor winds in, (1 - a) times when it pays out.",
            .meaning = "The gear loses more when its load drives it back (+) or when its motor drives (-) than in the other direction.",
            .sided = true,
            .parameters = {{"a", "1", 0.3, {-0.9, 0.9}, 0}},
            .starts = {-1, -0.4, 0.4, 1},
            .seen_by = {Experiment::kBreakAway, Experiment::kDeadBand, Experiment::kJointStiffness, Experiment::kCocontraction,
                        Experiment::kLog},
            .confused_with = {"gear.load_friction", "sensor.torque_scale"},
            .advice = "measure both directions by break-away tests: a profile has one friction for winding in and paying out",
            .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].gear.asymmetry += values[0]; }};
}

}  // namespace fusee::effects
