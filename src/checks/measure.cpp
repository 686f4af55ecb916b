#include "measure.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

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

}  // namespace fusee::checks
