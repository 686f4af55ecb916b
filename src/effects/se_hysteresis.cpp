#include "fusee/effects/effect.h"

namespace fusee::effects {

Effect make_se_hysteresis() {
    return {.id = "se.hysteresis",
            .law = "F_SE (1 + a z), z from -1 (unloading) to 1 (loading).",
            .meaning = "K_SE pulls this share harder while it is loaded and this share less while it is unloaded.",
            .sided = true,
            .parameters = {{"a", "1", 0.1, {0, 0.6}, 0}},
            .starts = {0.6, 1.5},
            .seen_by = {Experiment::kSpringPull, Experiment::kDeadBand, Experiment::kJointStiffness, Experiment::kCocontraction,
                        Experiment::kLog},
            .confused_with = {"gear.load_friction"},
            .advice = "look at the torsion spring: coils that rub, a leg that slips",
            .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].se_build.hysteresis += values[0]; }};
}

}  // namespace fusee::effects
