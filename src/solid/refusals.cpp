#include "refusals.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "fusee/core/units.h"
#include "fusee/solid/companions.h"
#include "fusee/solid/outline.h"
#include "fusee/solid/sweep.h"

namespace fusee::solid {

namespace {

using core::mm_from_m;
using Refusal = std::optional<core::Finding>;

constexpr double kSharpestFloor = 1.02;  // of half a cable: at 1 the floor has a cusp
constexpr double kLeastBore_mm = 0.5;    // a smaller bore is no suggestion
constexpr double kLeastLip_mm = 0.2;     // from the axis
constexpr double kLeastFloor_mm = 0.05;  // between bore and groove

/// The input of all refusals.
struct Geometry {
    const cam::Cam& cam;
    const PartOptions& options;
    const std::vector<SectionPoint>& section;
    std::string part;
    double least_h = 0.0, least_rho = 0.0;  ///< over the whole groove [mm]
    double half_cable = 0.0;                ///< [mm]
};

Geometry measure(const cam::Cam& cam, const PartOptions& options, const std::vector<SectionPoint>& section) {
    Geometry geometry{cam, options, section, to_string(cam.kind), 1e9, 1e9, mm_from_m(0.5 * cam.options.cable_diameter)};
    for (double psi = cam.groove_psi.low; psi <= cam.groove_psi.high; psi += 0.01) {
        const cam::PathPoint p = cam.path(psi);
        geometry.least_h = std::min(geometry.least_h, mm_from_m(p.h));
        geometry.least_rho = std::min(geometry.least_rho, mm_from_m(p.rho));
    }
    return geometry;
}

Refusal turns(const Geometry& geometry) {
    const double gap = least_turn_gap_mm(geometry.cam, geometry.section), rib = mm_from_m(geometry.options.groove.rib);
    if (gap >= rib) return std::nullopt;
    const cam::PathOptions& path = geometry.cam.options.path;
    return refusal("solid.turns", "the land between neighbouring turns is thinner than the rib", gap, rib, geometry.part,
                   path.lead == cam::Lead::kConstantPitch
                       ? core::change(geometry.part + ".path.pitch_mm", fmt::format("{:.2f}", mm_from_m(path.pitch) + rib - gap + 0.05))
                       : core::Suggestion(geometry.part + ".guide.z_mm larger")
                             .or_else(constant_pitch_change(geometry.part, geometry.options.groove, geometry.cam.options.cable_diameter)));
}

Refusal floor_folds(const Geometry& geometry) {
    const double least = geometry.half_cable * kSharpestFloor;
    if (geometry.least_rho > least) return std::nullopt;
    return refusal("solid.floor", "the groove's floor folds: the radius of the cable's centreline is not above half a cable",
                   geometry.least_rho, least, geometry.part,
                   core::change("cable.diameter_mm", core::number(0.99 * 2.0 * geometry.least_rho / kSharpestFloor, 3)));
}

Refusal misses_axis(const Geometry& geometry) {
    const double lip = geometry.least_h + geometry.section.front().offset_mm;
    if (!geometry.cam.closed() || lip >= kLeastLip_mm) return std::nullopt;
    return refusal("solid.axis", "the contour does not enclose the axis: on the idle arc its lips pass the axis on the wrong side", lip,
                   kLeastLip_mm, geometry.part,
                   helix_change(geometry.part, geometry.options.groove, geometry.cam.options.cable_diameter)
                       .or_else("a base spring whose arms differ less"));
}

Refusal anchor_fault(const Geometry& geometry) {
    const double hole = mm_from_m(geometry.options.features.anchor_hole_diameter);
    const double inside = geometry.options.hub.kind == HubKind::kThrough ? bore_reach_mm(geometry.options.hub) : kLeastLip_mm;
    const double left = mm_from_m(geometry.cam.path(geometry.cam.anchor_psi).h) - inside - kLeastLip_mm, widest = std::max(0.0, left);
    if (hole <= widest) return std::nullopt;
    const double bore = mm_from_m(geometry.options.hub.bore_diameter) - 2.0 * (hole - left + kLeastFloor_mm);
    core::Suggestion suggestion =
        core::change(geometry.part + ".features.anchor_hole_mm", widest > 0.0 ? fmt::format("{:.2f}", 0.95 * widest) : "0");
    if (widest <= 0.0) suggestion.noted(" and a clamp outside the part");
    if (geometry.options.hub.kind == HubKind::kThrough && bore > kLeastBore_mm)
        suggestion.or_else(core::change(geometry.part + ".hub.bore_mm", fmt::format("{:.2f}", bore)));
    core::Finding f = refusal("solid.anchor", "the anchor hole is wider than the part there", hole, widest, geometry.part, suggestion);
    f.bound = core::Bound::kAtMost;
    return f;
}

Refusal bore(const Geometry& geometry) {
    const double floor = geometry.least_h - geometry.half_cable, reach = bore_reach_mm(geometry.options.hub);
    if (geometry.options.hub.kind == HubKind::kOverhung || floor > reach + kLeastFloor_mm) return std::nullopt;
    const double fitting = mm_from_m(geometry.options.hub.bore_diameter) - 2.0 * (reach + 0.3 - floor);
    core::Suggestion smaller;
    if (fitting > kLeastBore_mm) smaller = core::change(geometry.part + ".hub.bore_mm", fmt::format("{:.2f}", fitting));
    return refusal("solid.bore", "the bore breaks into the groove's floor", floor, reach + kLeastFloor_mm, geometry.part,
                   smaller.or_else(overhung_change(geometry.part, geometry.options.hub)));
}

}  // namespace

core::Finding refusal(const char* rule, std::string what, double measured, double allowed, const std::string& where,
                      core::Suggestion suggestion) {
    core::Finding f = core::error_finding(rule, std::move(what), measured, core::Bound::kAtLeast, allowed, "mm");
    f.where = where;
    f.suggestion = std::move(suggestion);
    f.source = "geometry of the part";
    return f;
}

core::Findings check_geometry(const cam::Cam& cam, const PartOptions& options, const std::vector<SectionPoint>& section) {
    const Geometry geometry = measure(cam, options, section);
    core::Findings findings;
    if (const Refusal f = turns(geometry)) findings.push_back(*f);
    // Holes cannot be judged on a contour that folds or misses the axis. Only the first of these errors is reported.
    for (const auto& rule : {floor_folds, misses_axis})
        if (const Refusal f = rule(geometry)) {
            findings.push_back(*f);
            return findings;
        }
    for (const auto& rule : {anchor_fault, bore})
        if (const Refusal f = rule(geometry)) findings.push_back(*f);
    return findings;
}

}  // namespace fusee::solid
