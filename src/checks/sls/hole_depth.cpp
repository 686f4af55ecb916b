#include <fmt/format.h>

#include "fusee/core/units.h"
#include "measure.h"
#include "shape.h"

namespace fusee::checks {

namespace {

core::Findings measure_sls_hole_depth(const Design& design, const Allowed& allowed) {
    if (design.process.kind != ProcessKind::kSls) return {};
    const Hole deep = slenderest_hole(design.part);
    core::Finding f = judge(deep.depth / deep.diameter, {allowed("review")});
    f.what = fmt::format("depth of the slenderest hole: {}", deep.what);
    f.suggestion = change(design, deep.key, up(core::mm_from_m(deep.depth) / f.allowed));
    return {f};
}

}  // namespace

Rule sls_hole_depth() {
    return {"sls.hole_depth",         "a hole that traps powder",          "SLS: depth of the slenderest hole, in its diameters",
            "5 diameters (practice)", {review(kAtMost, "diameters", 5.0)}, measure_sls_hole_depth};
}

}  // namespace fusee::checks
