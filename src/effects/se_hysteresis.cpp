#include "fusee/effects/effect.h"

namespace fusee::effects {

Effect make_se_hysteresis() {
    return {.id = "se.hysteresis",
            .law = "F_SE (1 + a z), z from -1 (unloading) to 1 (loading).",
            .meaning = "The torque of K_SE is higher by this share while loading and lower by this share while unloading.",
            .sided = true,
            .parameters = {{"a", "1", 0.1, {0, 0.6}, 0}},
            .starts = {0.6, 1.5},
            .seen_by = spring_experiments(),
            .confused_with = {"gear.load_friction"},
            .advice = "check the torsion spring: coils rub or a leg slips",
            .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].se_build.hysteresis += values[0]; }};
}

}  // namespace fusee::effects
