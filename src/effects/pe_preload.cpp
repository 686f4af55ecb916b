#include "fusee/effects/effect.h"

namespace fusee::effects {

Effect make_pe_preload() {
    return {.id = "pe.preload",
            .law = "K_PE's base spring starts compressed (+) or slack (-).",
            .meaning = "The base spring of K_PE starts compressed (+) or slack (-).",
            .sided = true,
            .parameters = {{"y_0", "m", 0.002, {-0.01, 0.01}, 0}},
            .starts = {-1, 1},
            .seen_by = spring_experiments(),
            .confused_with = {"pe.radius"},
            .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].pe_build.preload += values[0]; }};
}

}  // namespace fusee::effects
