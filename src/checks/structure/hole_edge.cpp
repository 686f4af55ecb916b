#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_structure_hole_edge(const Design& design, const Allowed& allowed) {
    const auto hole = anchor_hole(design.part);
    if (!hole || !design.part.cam.closed() || design.part.section.empty()) return {};
    const double rim = lip_offset(design.part) + design.part.options.flange_height;
    const Nearest nearest = distance_inside(contour(design.part.cam), rim, hole->centre);
    core::Finding f =
        compare(mm_from_m(nearest.distance - hole->radius), {allowed("review", mm_from_m(process_limits(design.process).wall))});
    f.what = "wall between the cable's anchor hole and the rim of the upper flange";
    locate(f, design, hole->at);
    f.suggestion = change(design, "flange_height_mm", up(mm_from_m(design.part.options.flange_height) + f.allowed - f.measured));
    return {f};
}

}  // namespace

Rule structure_hole_edge() {
    return {"structure.hole_edge",
            "the anchor hole tearing out of the rim",
            "planar: wall from the anchor hole to the rim of the flange",
            "the process's thinnest wall",
            {of_process(review(kAtLeast, "mm", "the process's wall"))},
            measure_structure_hole_edge};
}

}  // namespace fusee::checks
