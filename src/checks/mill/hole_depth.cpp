#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_mill_hole_depth(const Design& design, const Allowed& allowed) {
    return {judge_slenderest_hole(design, {allowed("required"), allowed("review")})};
}

}  // namespace

Rule mill_hole_depth() {
    return {"mill.hole_depth",
            "a hole too deep to drill",
            "milled: depth of the slenderest hole, in its diameters",
            "hole 4 D, at most 10: zekes3d, Xometry",
            {required(kAtMost, "diameters", 10.0), review(kAtMost, "diameters", 4.0)},
            measure_mill_hole_depth,
            is_milled};
}

}  // namespace fusee::checks
