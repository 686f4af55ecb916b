#include "fusee/effects/effect.h"

namespace fusee::effects {

Effect make_gear_load_friction() {
    return {
        .id = "gear.load_friction",
        .law = "The friction coefficient differs from the nominal one: mu (1 + e).",
        .meaning = "The gear loses more (+) or less (-) of its load to friction than the nominal mu says.",
        .sided = true,
        .parameters = {{"e", "1", 0.25, {-0.9, 1.5}, 0}},
        .starts = {-2, -1, -0.4, 0.4, 1, 2},
        .seen_by = {Experiment::kBreakAway, Experiment::kDeadBand, Experiment::kJointStiffness, Experiment::kCocontraction,
                    Experiment::kLog},
        .confused_with = {"gear.coulomb", "gear.stribeck", "gear.load_quadratic"},
        .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].gear.load_friction *= 1.0 + values[0]; }};
}

}  // namespace fusee::effects
