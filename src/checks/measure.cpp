#include "measure.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "fusee/core/units.h"

namespace fusee::checks {

bool is_milled(const Design& design) { return design.process.kind == ProcessKind::kMill || design.process.kind == ProcessKind::kMill4; }
bool is_stacked(const Design& design) { return design.process.kind == ProcessKind::kEdm || design.process.kind == ProcessKind::kLaser; }

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

std::string where(const Design& design, double psi) { return fmt::format("{} at psi {:.1f} deg", name(design), core::deg_from_rad(psi)); }

core::Place place(const cam::PathPoint& p, double offset) {
    const double h = p.h + offset, c = std::cos(p.psi), s = std::sin(p.psi);
    return {p.psi, {core::mm_from_m(h * c - p.slope * s), core::mm_from_m(h * s + p.slope * c), core::mm_from_m(p.z)}};
}

}  // namespace fusee::checks
