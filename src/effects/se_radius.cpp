#include "fusee/effects/effect.h"

namespace fusee::effects {

Effect make_se_radius() {
    return {.id = "se.radius",
            .law = "Every arm of K_SE's spool is longer or shorter.",
            .meaning = "Every arm of K_SE's spool is longer (+) or shorter (-): cable thickness, over- or under-cut, shrinkage.",
            .sided = true,
            .parameters = {{"dr", "m", 0.0015, {-0.006, 0.006}, 0}},
            .starts = {-1, 1},
            .seen_by = spring_experiments(),
            .confused_with = {"se.rate"},
            .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].se_build.radius += values[0]; }};
}

}  // namespace fusee::effects
