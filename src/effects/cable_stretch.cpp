#include "fusee/effects/effect.h"

namespace fusee::effects {

Effect make_cable_stretch() {
    return {.id = "cable.stretch",
            .law = "Compliance in series with K_SE.",
            .meaning = "The cable stretches in series with K_SE: together they are softer than designed.",
            .sided = true,
            .parameters = {{"k_c", "Nm/rad", 1.0, {0.05, 1000}, 0}},
            .starts = {0.5, 1, 2.5, 8},
            .seen_by = spring_experiments(),
            .confused_with = {"se.rate", "se.radius"},
            .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].se_build.stretch += 1.0 / values[0]; }};
}

}  // namespace fusee::effects
