#include "fusee/effects/effect.h"

namespace fusee::effects {

Effect make_pe_radius() {
    return {.id = "pe.radius",
            .law = "Every arm of K_PE's cam is longer or shorter.",
            .meaning = "Every arm of K_PE's cam is longer (+) or shorter (-): cable thickness, over- or under-cut, shrinkage.",
            .sided = true,
            .parameters = {{"dr", "m", 0.001, {-0.004, 0.004}, 0}},
            .starts = {-1, 1},
            .seen_by = spring_experiments(),
            .confused_with = {"pe.rate"},
            .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].pe_build.radius += values[0]; }};
}

}  // namespace fusee::effects
