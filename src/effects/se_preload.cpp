#include "fusee/effects/effect.h"

namespace fusee::effects {

Effect make_se_preload() {
    return {.id = "se.preload",
            .law = "K_SE's base spring starts wound (+) or slack (-).",
            .meaning = "The base spring of K_SE starts wound (+) or slack (-).",
            .sided = true,
            .parameters = {{"phi_0", "rad", 0.22, {-1.5, 1.5}, 0}},
            .starts = {-1, 1},
            .seen_by = spring_experiments(),
            .confused_with = {},
            .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].se_build.preload += values[0]; }};
}

}  // namespace fusee::effects
