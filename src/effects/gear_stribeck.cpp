#include "fusee/effects/effect.h"

namespace fusee::effects {

Effect make_gear_stribeck() {
    return {.id = "gear.stribeck",
            .law = "Friction at rest is (1 + s) times that in motion; it falls as s exp(-(v/v_s)^2).",
            .meaning = "The gear friction is larger at rest than in motion: the gear sticks, then slips.",
            .sided = true,
            .parameters = {{"s", "1", 0.6, {0, 3}, 0}, {"v_s", "rad/s", 0.06, {0.005, 0.5}, 0.06, {0.03, 0.1, 0.25}}},
            .starts = {0.5, 1.5},
            .seen_by = {Experiment::kBreakAway, Experiment::kDeadBand, Experiment::kJointStiffness, Experiment::kCocontraction,
                        Experiment::kLog},
            .confused_with = {"gear.load_friction"},
            .apply = [](BuiltRig& rig, int side, std::span<const double> values) {
                rig.sides[side].gear.stribeck += values[0];
                rig.sides[side].gear.stribeck_speed = values[1];
            }};
}

}  // namespace fusee::effects
