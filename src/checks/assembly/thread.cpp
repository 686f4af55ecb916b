#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_assembly_thread(const Design& design, const Allowed& allowed) {
    const double hole = design.part.options.features.anchor_hole_diameter, d = design.cable.diameter;
    if (hole <= 0.0) return {};
    core::Finding f = compare(hole / d, {allowed("required"), allowed("review")});
    f.what = "diameter of the anchor hole, through which the cable is threaded";
    f.where = at_anchor(design);
    f.suggestion = change(design, "features.anchor_hole_mm", up(mm_from_m(f.allowed * d)));
    return {f};
}

}  // namespace

Rule assembly_thread() {
    return on_cable({"assembly.thread",
                     "a cable that does not go through its hole",
                     "anchor hole over the cable",
                     "1.2 d, at least d (practice)",
                     {required(kAtLeast, "d", 1.0), review(kAtLeast, "d", 1.2)},
                     measure_assembly_thread});
}

}  // namespace fusee::checks
