#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"
#include "measure.h"
#include "rules.h"
#include "shape.h"

namespace fusee::checks {

namespace {

/// Radius of the circle that the lips and flanges sweep as the cam turns [m].
double swept_radius(const Design& design, const cam::PathPoint& p) {
    const double lip = design.part.section.empty() ? 0.0 : lip_offset(design.part);
    return std::hypot(p.h + lip + design.part.options.flange_height, p.slope);
}

core::Findings run(const Design& design) {
    const cam::Guide& guide = design.part.cam.options.guide;
    const std::vector<cam::PathPoint> path = contour(design.part.cam);
    if (guide.kind == cam::GuideKind::kParallel || guide.distance <= 0.0 || path.empty()) return {};
    const auto farthest = std::max_element(path.begin(), path.end(),
                                           [&](const auto& a, const auto& b) { return swept_radius(design, a) < swept_radius(design, b); });
    const double idler = guide.kind == cam::GuideKind::kIdler ? guide.radius : 0.0, half_cable = 0.5 * design.cable.diameter;
    const double swept = swept_radius(design, *farthest), room = guide.distance - idler - half_cable;
    core::Finding f = at_most(core::mm_from_m(swept), {{}, core::mm_from_m(room)}, "mm");
    f.what = "radius swept by the turning part, against the room up to the guide";
    f.where = where(design, farthest->psi);
    f.place = place(*farthest, swept - std::hypot(farthest->h, farthest->slope));
    f.suggestion = fmt::format("{}.guide.distance_mm = {}", name(design), up(core::mm_from_m(swept + idler + half_cable)));
    return {f};
}

}  // namespace

Rule cam_contour_radius() {
    return {"cam.contour_radius", "the turning part striking its guide", "geometry: swept circle against the guide", run};
}

}  // namespace fusee::checks
