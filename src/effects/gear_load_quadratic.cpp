#include "fusee/effects/effect.h"

namespace fusee::effects {

Effect make_gear_load_quadratic() {
    return {.id = "gear.load_quadratic",
            .law = "Friction that grows with the load squared: b tau_load^2 in addition to mu tau_load.",
            .meaning = "The gear's friction grows faster than its load.",
            .sided = true,
            .parameters = {{"b", "1/Nm", 0.08, {-0.1, 0.4}, 0}},
            .starts = {-0.7, 0.7, 1.5},
            .seen_by = {Experiment::kBreakAway, Experiment::kDeadBand, Experiment::kJointStiffness, Experiment::kCocontraction,
                        Experiment::kLog},
            .confused_with = {"gear.load_friction", "gear.coulomb"},
            .advice = "measure the friction by break-away tests and name the table in rig.gear_friction_table",
            .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].gear.quadratic += values[0]; }};
}

}  // namespace fusee::effects
