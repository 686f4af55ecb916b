#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_sls_hole_depth(const Design& design, const Allowed& allowed) {
    if (design.process.kind != ProcessKind::kSls) return {};
    return {judge_slenderest_hole(design, {allowed("review")})};
}

}  // namespace

Rule sls_hole_depth() {
    return {"sls.hole_depth",         "a hole that traps powder",          "SLS: depth of the slenderest hole, in its diameters",
            "5 diameters (practice)", {review(kAtMost, "diameters", 5.0)}, measure_sls_hole_depth};
}

}  // namespace fusee::checks
