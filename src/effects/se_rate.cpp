#include "fusee/effects/effect.h"

namespace fusee::effects {

Effect make_se_rate() {
    return {.id = "se.rate",
            .law = "The rate of K_SE's base spring differs from the nominal one: k (1 + e).",
            .meaning = "The base spring of K_SE is stiffer (+) or softer (-) than its nominal rate.",
            .sided = true,
            .parameters = {{"e", "1", 0.12, {-0.6, 1}, 0}},
            .starts = {-1, 1},
            .seen_by = spring_experiments(),
            .confused_with = {"se.radius", "cable.stretch"},
            .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].se_build.rate += values[0]; }};
}

}  // namespace fusee::effects
