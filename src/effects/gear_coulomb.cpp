#include "fusee/effects/effect.h"

namespace fusee::effects {

Effect make_gear_coulomb() {
    return {.id = "gear.coulomb",
            .law = "Constant friction in addition to mu tau_load.",
            .meaning = "The gear has a constant friction in addition to mu times the load, for example from a seal or a preloaded bearing.",
            .sided = true,
            .parameters = {{"tau_c", "Nm", 0.04, {0, 0.5}, 0}},
            .starts = {0.5, 1.5},
            .seen_by = {Experiment::kBreakAway, Experiment::kDeadBand, Experiment::kJointStiffness, Experiment::kCocontraction,
                        Experiment::kLog},
            .confused_with = {"gear.load_friction", "gear.load_quadratic"},
            .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].gear.coulomb += values[0]; }};
}

}  // namespace fusee::effects
