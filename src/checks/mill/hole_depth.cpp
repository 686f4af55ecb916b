#include <fmt/format.h>

#include "fusee/core/units.h"
#include "measure.h"
#include "shape.h"

namespace fusee::checks {

namespace {

core::Findings measure_mill_hole_depth(const Design& design, const Allowed& allowed) {
    if (!is_milled(design)) return {};
    const Hole deep = slenderest_hole(design.part);
    core::Finding f = judge(deep.depth / deep.diameter, {allowed("required"), allowed("review")});
    f.what = fmt::format("depth of the slenderest hole: {}", deep.what);
    f.suggestion = change(design, deep.key, up(core::mm_from_m(deep.depth) / f.allowed));
    return {f};
}

}  // namespace

Rule mill_hole_depth() {
    return {"mill.hole_depth",
            "a hole too deep to drill",
            "milled: depth of the slenderest hole, in its diameters",
            "hole 4 D, at most 10: zekes3d, Xometry",
            {required(kAtMost, "diameters", 10.0), review(kAtMost, "diameters", 4.0)},
            measure_mill_hole_depth};
}

}  // namespace fusee::checks
