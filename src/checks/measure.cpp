#include "measure.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "fusee/checks/along.h"
#include "fusee/checks/limits.h"
#include "shape.h"

namespace fusee::checks {

Rule on_cable(Rule rule) {
    rule.family = cam::Family::kCable;
    return rule;
}

std::string name(const Design& design) { return cam::to_string(design.part.cam.kind); }

std::string key_of(const Design& design, const std::string& key) { return name(design) + "." + key; }

core::Suggestion change(const Design& design, const std::string& key, std::string value) {
    return core::change(key_of(design, key), std::move(value));
}

core::Suggestion without_anchor_hole(const Design& design) {
    return change(design, "features.anchor_hole_mm", "0").noted(" and a knot or clamp outside the part");
}

std::string where(const Design& design, double psi) { return fmt::format("{} at psi {:.1f} deg", name(design), deg_from_rad(psi)); }

std::string at_anchor(const Design& design) { return where(design, design.part.cam.anchor_psi); }
std::string at_leg_slot(const Design& design) {
    return fmt::format("{} at body angle {:.1f} deg", name(design), deg_from_rad(design.part.options.features.leg_slot_angle));
}
std::string along_groove(const Design& design) { return name(design) + " all along the groove"; }

core::Place place(const cam::PathPoint& p, double offset) {
    const double h = p.h + offset, c = std::cos(p.psi), s = std::sin(p.psi);
    return {p.psi, {mm_from_m(h * c - p.slope * s), mm_from_m(h * s + p.slope * c), mm_from_m(p.z)}};
}

void locate(core::Finding& finding, const Design& design, const cam::PathPoint& point, double offset) {
    finding.where = where(design, point.psi);
    finding.place = place(point, offset);
}

core::Finding judge_bend(double ratio, const Design& design, const Allowed& allowed) {
    const CableLimits& table = cable_limits(design.cable.construction);
    const bool own = design.cable.min_bend_ratio > 0.0;
    core::Finding f = own ? compare(ratio, {allowed("required", design.cable.min_bend_ratio)})
                          : compare(ratio, {allowed("required", table.critical), allowed("review", table.recommended)});
    f.source = own ? "cable.min_bend_ratio" : table.source;
    return f;
}

core::Finding judge_slenderest_hole(const Design& design, std::initializer_list<EffectiveLimit> limits) {
    const Hole deep = slenderest_hole(design.part);
    core::Finding f = compare(deep.depth / deep.diameter, limits);
    f.what = fmt::format("depth of the slenderest hole: {}", deep.what);
    f.suggestion = change(design, deep.key, up(mm_from_m(deep.depth) / f.allowed));
    return f;
}

BreakingLoad breaking_load(const Cable& cable) {
    if (cable.breaking_load > 0.0) return {cable.breaking_load, false};
    return {usual_cable(cable.construction, cable.diameter), true};
}

std::string BreakingLoad::remark(const Cable& cable) const {
    if (!estimated) return "";
    return fmt::format("; no breaking load is stated: {:.0f} N is an estimate for {:.3g} mm of {}", newton, core::mm_from_m(cable.diameter),
                       cable.construction);
}

double bend_ratio(const cam::Contact& contact, double d) { return (2.0 * contact.path.rho - d) / d; }

double floor_pressure(const cam::Contact& contact, double d) {
    return 2.0 * contact.path.rho <= d ? 0.0 : 2.0 * contact.arm.tension / ((2.0 * contact.path.rho - d) * d);
}

std::span<const AlongCam> along_cam() {
    static constexpr std::array<AlongCam, 3> kAll{
        {{"cable.bend_ratio", [](const cam::Cam& cam, const cam::Contact& c) { return bend_ratio(c, cam.options.cable_diameter); }},
         {"cable.pressure",
          [](const cam::Cam& cam, const cam::Contact& c) { return floor_pressure(c, cam.options.cable_diameter) / kPaPerMPa; }},
         {"cable.fleet",
          [](const cam::Cam& cam, const cam::Contact& c) { return core::deg_from_rad(std::abs(fleet_from_groove(cam, c))); }}}};
    return kAll;
}

}  // namespace fusee::checks
