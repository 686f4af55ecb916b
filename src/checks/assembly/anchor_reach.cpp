#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_assembly_anchor_reach(const Design& design, const Allowed& allowed) {
    const spring::BaseSpring& s = design.spring;
    const auto hole = anchor_hole(design.part);
    const double outside = 0.5 * (s.coil_diameter + s.wire_diameter);
    core::Finding f = compare(mm_from_m(std::hypot(hole->centre[0], hole->centre[1]) - hole->radius - outside), {allowed("review")});
    f.what = fmt::format("distance from the spring's coils, {:.2f} mm from the axis, to the anchor hole", mm_from_m(outside));
    locate(f, design, hole->at, -hole->radius);
    f.suggestion = change(design, "spring.coil_mm", down(mm_from_m(s.coil_diameter) - 2.0 * (f.allowed - f.measured)));
    return {f};
}

}  // namespace

Rule assembly_anchor_reach() {
    return on_cable({"assembly.anchor_reach",
                     "an anchor hidden under the spring",
                     "distance from the torsion spring's outside to the anchor hole on the top face",
                     "geometry: the knot is tied beside the spring",
                     {review(kAtLeast, "mm", 0.0)},
                     measure_assembly_anchor_reach,
                     has_torsion_anchor,
                     {need::kWire, need::kCoil}});
}

}  // namespace fusee::checks
