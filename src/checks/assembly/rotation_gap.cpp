#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_assembly_rotation_gap(const Design& design, const Allowed& allowed) {
    const auto gap = guide_gap(design.part);
    if (!gap || *gap < 0.0) return {};  // collision: cam.contour_radius reports it
    core::Finding f = compare(mm_from_m(*gap), {allowed("review")});
    f.what = "gap between the turning part and its guide";
    f.suggestion = change(design, "guide.distance_mm", up(mm_from_m(design.part.cam.options.guide.distance) + f.allowed - f.measured));
    return {f};
}

}  // namespace

Rule assembly_rotation_gap() {
    return {"assembly.rotation_gap",
            "a part that touches its guide as it turns",
            "gap between the circle that lips and flanges sweep and the guide",
            "1 mm (practice)",
            {review(kAtLeast, "mm", 1.0)},
            measure_assembly_rotation_gap};
}

}  // namespace fusee::checks
