#include "room.h"

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

/// What the refusals are about.
struct Room {
    const cam::Cam& cam;
    const PartOptions& options;
    const std::vector<SectionPoint>& section;
    std::string part;
    double least_h = 0.0, least_rho = 0.0;  ///< over the whole groove [mm]
    double half_cable = 0.0;                ///< [mm]
};

Room measure(const cam::Cam& cam, const PartOptions& options, const std::vector<SectionPoint>& section) {
    Room room{cam, options, section, to_string(cam.kind), 1e9, 1e9, mm_from_m(0.5 * cam.options.cable_diameter)};
    for (double psi = cam.groove_psi.low; psi <= cam.groove_psi.high; psi += 0.01) {
        const cam::PathPoint p = cam.path(psi);
        room.least_h = std::min(room.least_h, mm_from_m(p.h));
        room.least_rho = std::min(room.least_rho, mm_from_m(p.rho));
    }
    return room;
}

Refusal turns(const Room& room) {
    const double gap = least_turn_gap_mm(room.cam, room.section), rib = mm_from_m(room.options.groove.rib);
    if (gap >= rib) return std::nullopt;
    const cam::PathOptions& path = room.cam.options.path;
    return refusal("solid.turns", "the land between neighbouring turns is thinner than the rib", gap, rib, room.part,
                   path.lead == cam::Lead::kConstantPitch
                       ? fmt::format("{}.path.pitch_mm = {:.2f}", room.part, mm_from_m(path.pitch) + rib - gap + 0.05)
                       : fmt::format("{}.guide.z_mm larger, or {}", room.part,
                                     constant_pitch_change(room.part, room.options.groove, room.cam.options.cable_diameter)));
}

Refusal floor_folds(const Room& room) {
    const double least = room.half_cable * kSharpestFloor;
    if (room.least_rho > least) return std::nullopt;
    return refusal("solid.floor", "the groove's floor folds: the cable's centreline bends within half a cable", room.least_rho, least,
                   room.part, fmt::format("cable.diameter_mm = {:.3g}", 0.99 * 2.0 * room.least_rho / kSharpestFloor));
}

Refusal misses_axis(const Room& room) {
    const double lip = room.least_h + room.section.front().offset_mm;
    if (!room.cam.closed() || lip >= kLeastLip_mm) return std::nullopt;
    return refusal(
        "solid.axis", "the contour does not go round the axis: on the idle arc its lips pass the axis on the wrong side", lip, kLeastLip_mm,
        room.part,
        helix_change(room.part, room.options.groove, room.cam.options.cable_diameter) + ", or a base spring whose arms differ less");
}

Refusal anchor(const Room& room) {
    const double hole = mm_from_m(room.options.features.anchor_hole_diameter);
    const double inside = room.options.hub.kind == HubKind::kThrough ? bore_reach_mm(room.options.hub) : kLeastLip_mm;
    const double left = mm_from_m(room.cam.path(room.cam.anchor_psi).h) - inside - kLeastLip_mm, widest = std::max(0.0, left);
    if (hole <= widest) return std::nullopt;
    const double bore = mm_from_m(room.options.hub.bore_diameter) - 2.0 * (hole - left + kLeastFloor_mm);
    std::string suggestion = widest > 0.0 ? fmt::format("{}.features.anchor_hole_mm = {:.2f}", room.part, 0.95 * widest)
                                          : fmt::format("{}.features.anchor_hole_mm = 0 and a clamp outside the part", room.part);
    if (room.options.hub.kind == HubKind::kThrough && bore > kLeastBore_mm)
        suggestion += fmt::format(", or {}.hub.bore_mm = {:.2f}", room.part, bore);
    core::Finding f = refusal("solid.anchor", "the anchor hole is as wide as the part is there", hole, widest, room.part, suggestion);
    f.bound = core::Bound::kAtMost;
    return f;
}

Refusal bore(const Room& room) {
    const double floor = room.least_h - room.half_cable, reach = bore_reach_mm(room.options.hub);
    if (room.options.hub.kind == HubKind::kOverhung || floor > reach + kLeastFloor_mm) return std::nullopt;
    const double fitting = mm_from_m(room.options.hub.bore_diameter) - 2.0 * (reach + 0.3 - floor);
    const std::string smaller = fitting > kLeastBore_mm ? fmt::format("{}.hub.bore_mm = {:.2f}, or ", room.part, fitting) : "";
    return refusal("solid.bore", "the bore breaks into the groove's floor", floor, reach + kLeastFloor_mm, room.part,
                   smaller + overhung_change(room.part, room.options.hub));
}

}  // namespace

core::Finding refusal(const char* rule, std::string what, double measured, double allowed, const std::string& where,
                      std::string suggestion) {
    core::Finding f = core::error_finding(rule, std::move(what), measured, core::Bound::kAtLeast, allowed, "mm");
    f.where = where;
    f.suggestion = std::move(suggestion);
    f.source = "geometry of the part";
    return f;
}

core::Findings check_room(const cam::Cam& cam, const PartOptions& options, const std::vector<SectionPoint>& section) {
    const Room room = measure(cam, options, section);
    core::Findings findings;
    if (const Refusal f = turns(room)) findings.push_back(*f);
    // A contour that folds or misses the axis says nothing of holes: the first of these hides the rest.
    for (const auto& rule : {floor_folds, misses_axis})
        if (const Refusal f = rule(room)) {
            findings.push_back(*f);
            return findings;
        }
    for (const auto& rule : {anchor, bore})
        if (const Refusal f = rule(room)) findings.push_back(*f);
    return findings;
}

}  // namespace fusee::solid
