#include <limits>

#include "fusee/cam/contact.h"
#include "means.h"

namespace fusee::checks {

namespace {

struct Clearance {
    double gap = 0.0;  ///< from the hole's edge to the floor of the working arc [m]
    cam::PathPoint at;
};

/// Distance of an anchor hole at `psi` from the working floor. `structure.anchor` judges the other turns of a helix.
Clearance clearance(const cam::Cam& cam, double psi, double radius) {
    const cam::PathPoint anchor = cam.path(psi);
    const core::Place hole = place(anchor, -radius);  // it touches the pitch curve from inside
    Clearance least{std::numeric_limits<double>::infinity(), anchor};
    for (const cam::Contact& c : cam.working) {
        if (!cam.closed() && std::abs(c.path.psi - psi) > core::kPi) continue;
        const core::Place floor = place(c.path, -0.5 * cam.options.cable_diameter);
        const double apart = m_from_mm(std::hypot(floor.point_mm[0] - hole.point_mm[0], floor.point_mm[1] - hole.point_mm[1])) - radius;
        if (apart < least.gap) least = {apart, c.path};
    }
    return least;
}

core::Findings measure_structure_anchor_floor(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    const double radius = 0.5 * design.part.options.features.anchor_hole_diameter;
    if (radius <= 0.0 || !cam.path || cam.working.empty()) return {};
    const Clearance found = clearance(cam, cam.anchor_psi, radius);
    core::Finding f = compare(mm_from_m(found.gap), {allowed("required", mm_from_m(0.5 * design.cable.diameter))});
    f.what = "distance from the anchor hole to the working floor";
    locate(f, design, found.at, -0.5 * cam.options.cable_diameter);
    f.suggestion = without_anchor_hole(design);
    for (const double margin : cam::margins_by_distance(cam)) {
        if (clearance(cam, cam::anchor_direction(cam, margin), radius).gap < 0.55 * design.cable.diameter) continue;
        f.suggestion = change(design, "path.margin_deg", fmt::format("{:.0f}", deg_from_rad(margin)));
        break;
    }
    return {f};
}

}  // namespace

Rule structure_anchor_floor() {
    return on_cable({"structure.anchor_floor",
                     "an anchor hole that cuts into the working floor",
                     "least distance from the hole to the working floor",
                     "geometry: the working floor defines the arm",
                     {required(kAtLeast, "mm", "half a cable")},
                     measure_structure_anchor_floor});
}

}  // namespace fusee::checks
