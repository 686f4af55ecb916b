#include <vector>

#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_mill4_swing(const Design& design, const Allowed& allowed) {
    const std::vector<cam::PathPoint> path = contour(design.part.cam);
    if (design.process.kind != ProcessKind::kMill4 || path.empty()) return {};
    const cam::PathPoint& far = farthest(design.part, path);
    const double swing = mm_from_m(2.0 * swept_radius(design.part, far));
    const double space = mm_from_m(std::min(design.process.build_x, design.process.build_y));
    core::Finding f = compare(swing, {allowed("required", space)});
    f.what = "diameter that the part sweeps about its axis";
    locate(f, design, far);
    f.suggestion = scale_arms(design, f.allowed / f.measured);
    return {f};
}

}  // namespace

Rule mill4_swing() {
    return {"mill4.swing",
            "a part that strikes the machine as it turns",
            "four axes: diameter swept as the part turns about its axis",
            "process.build_mm",
            {required(kAtMost, "mm", "the smaller of process.build_mm across the axis")},
            measure_mill4_swing};
}

}  // namespace fusee::checks
