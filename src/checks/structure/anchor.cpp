#include "means.h"

namespace fusee::checks {

namespace {

struct Neighbour {
    double wall;  ///< from the hole's edge [m]
    const char* what;
    bool from_inside = true;  ///< a smaller hole, whose far edge stays at the pitch curve, leaves a thicker wall
    bool turns = false;       ///< it may be moved to another angle
};

/// The neighbours of the hole, which runs axially from the groove's plane to a face.
std::vector<Neighbour> neighbours(const Design& design, const cam::PathPoint& anchor, Vec2 centre, double radius) {
    const solid::PartOptions& options = design.part.options;
    std::vector<Neighbour> all;
    if (options.hub.kind == solid::HubKind::kThrough) all.push_back({distance_to_bore(options.hub, centre) - radius, "bore"});
    if (solid::anchor_leads_down(design.part.cam, options)) return all;  // neither slot nor turns are below it
    if (has_slot(options.features)) all.push_back({leg_slot(options.features).distance(centre) - radius, "spring leg's slot", true, true});
    if (design.part.cam.closed()) return all;
    std::vector<cam::PathPoint> above;  // turns between the hole's start and the top
    for (const cam::PathPoint& p : contour(design.part.cam))
        if (p.z > anchor.z && std::abs(p.psi - anchor.psi) > core::kPi) above.push_back(p);
    if (!above.empty())
        all.push_back({distance_inside(above, -0.5 * design.cable.diameter, centre).distance - radius, "groove of the turns above", false});
    return all;
}

core::Findings measure_structure_anchor(const Design& design, const Allowed& allowed) {
    const auto hole = anchor_hole(design.part);
    if (!hole) return {};
    const auto& [centre, radius, anchor] = *hole;
    const std::vector<Neighbour> all = neighbours(design, anchor, centre, radius);
    if (all.empty()) return {};
    const Neighbour nearest =
        *std::min_element(all.begin(), all.end(), [](const Neighbour& a, const Neighbour& b) { return a.wall < b.wall; });
    core::Finding f = compare(mm_from_m(nearest.wall), {allowed("required", mm_from_m(process_limits(design.process).wall))});
    f.what = fmt::format("wall between the cable's anchor hole and the {}", nearest.what);
    f.where = at_anchor(design);
    f.place = place(anchor, -radius);
    const double smaller = 2.0 * radius - m_from_mm(f.allowed - f.measured);  // its far edge stays at the pitch curve
    f.suggestion = nearest.from_inside && smaller > 0.0 ? change(design, "features.anchor_hole_mm", down(mm_from_m(smaller)))
                                                        : without_anchor_hole(design);
    if (nearest.turns)
        f.suggestion.or_else(change(design, "features.leg_slot_angle_deg",
                                    fmt::format("{:.0f}", deg_from_rad(std::atan2(-centre[1], -centre[0])))));  // opposite the hole
    return {f};
}

}  // namespace

Rule structure_anchor() {
    return on_cable({"structure.anchor",
                     "the anchor hole breaking into bore, slot or another turn",
                     "least wall from the hole to bore, slot and the turns above",
                     "the process's thinnest wall",
                     {of_process(required(kAtLeast, "mm", "the process's wall"))},
                     measure_structure_anchor});
}

}  // namespace fusee::checks
