#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_cable_knot(const Design& design, const Allowed& allowed) {
    const double hole = design.part.options.features.anchor_hole_diameter, d = design.cable.diameter;
    if (hole <= 0.0) return {};
    const double tolerance = process_limits(design.process).tolerance, width = termination_limits(design.cable).width;
    core::Finding f = compare((hole + tolerance) / d, {allowed("review", width)});
    f.what = fmt::format("width of the anchor hole with its tolerance, {:g} mm, which the cable's {} has to bridge", mm_from_m(tolerance),
                         to_string(design.cable.termination));
    f.where = at_anchor(design);
    f.suggestion = change(design, "features.anchor_hole_mm", down(mm_from_m(f.allowed * d - tolerance)));
    return {f};
}

}  // namespace

Rule cable_knot() {
    return {"cable.knot",
            "a knot or sleeve pulled through its hole",
            "diameter of the anchor hole and the process's tolerance",
            "width of the termination (table 6)",
            {review(kAtMost, "d", "width of the termination (table 6)")},
            measure_cable_knot};
}

}  // namespace fusee::checks
