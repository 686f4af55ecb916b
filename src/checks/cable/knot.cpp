#include <fmt/format.h>

#include "fusee/core/units.h"
#include "measure.h"

namespace fusee::checks {

namespace {

core::Findings measure_cable_knot(const Design& design, const Allowed& allowed) {
    const double hole = design.part.options.features.anchor_hole_diameter, d = design.cable.diameter;
    if (hole <= 0.0) return {};
    core::Finding f = judge(hole / d, {allowed("review")});
    f.what = "width of the anchor hole, which the cable's knot has to bridge";
    f.where = where(design, design.part.cam.anchor_psi);
    f.suggestion = fmt::format("{}.features.anchor_hole_mm = {}", name(design), down(core::mm_from_m(f.allowed * d)));
    return {f};
}

}  // namespace

Rule cable_knot() {
    return {"cable.knot",
            "a knot pulled through its hole",
            "diameter of the anchor hole",
            "an overhand knot is about 3 d wide (practice)",
            {review(kAtMost, "d", 3.0)},
            measure_cable_knot};
}

}  // namespace fusee::checks
