#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_cam_contour_radius(const Design& design, const Allowed& allowed) {
    const cam::Guide& guide = design.part.cam.options.guide;
    const std::vector<cam::PathPoint> path = contour(design.part.cam);
    if (guide.kind == cam::GuideKind::kParallel || guide.distance <= 0.0 || path.empty()) return {};
    const cam::PathPoint& far = farthest(design.part, path);
    const double idler = guide.kind == cam::GuideKind::kIdler ? guide.radius : 0.0, half_cable = 0.5 * design.cable.diameter;
    const double swept = swept_radius(design.part, far), space = guide.distance - idler - half_cable;
    core::Finding f = compare(mm_from_m(swept), {allowed("review", mm_from_m(space))});
    f.what = "radius swept by the turning part, against the distance to the guide";
    locate(f, design, far, swept - std::hypot(far.h, far.slope));
    f.suggestion = change(design, "guide.distance_mm", up(mm_from_m(swept + idler + half_cable)));
    return {f};
}

}  // namespace

Rule cam_contour_radius() {
    return {"cam.contour_radius",
            "the turning part striking its guide",
            "largest radius of lips and flanges, swept by turning",
            "geometry: swept circle against the guide",
            {review(kAtMost, "mm", "the distance of point or idler less its radius and d/2")},
            measure_cam_contour_radius};
}

}  // namespace fusee::checks
