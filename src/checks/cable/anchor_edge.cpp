#include "means.h"

namespace fusee::checks {

namespace {

bool has_anchor(const Design& design) { return design.part.options.features.anchor_hole_diameter > 0.0; }

core::Findings measure_cable_anchor_edge(const Design& design, const Allowed& allowed) {
    const double d = design.cable.diameter;
    core::Finding f = compare(design.part.options.features.anchor_edge_radius / d, {allowed("review")});
    f.what = "radius of the anchor hole's edge, over which the cable bends to its end";
    f.where = at_anchor(design);
    f.suggestion = change(design, "features.anchor_edge_mm", up(mm_from_m(f.allowed * d))).noted(": round it by hand");
    return {f};
}

}  // namespace

Rule cable_anchor_edge() {
    return {"cable.anchor_edge",
            "an edge that cuts the cable where it enters its hole",
            "radius of the anchor hole's edge; the part is made with a sharp one, features.anchor_edge_mm is rounded by hand",
            "Sava: half the strength is left at D/d 1, the end of its table; Samson: D/d 3 where a rope is deflected",
            {review(kAtLeast, "d", 0.5)},
            measure_cable_anchor_edge,
            has_anchor};
}

}  // namespace fusee::checks
