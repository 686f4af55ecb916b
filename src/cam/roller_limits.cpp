#include "roller_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "idle_arc.h"
#include "refusal.h"
#include "scan.h"

namespace fusee::cam {

namespace {

using core::mm_from_m;

/// Convex everywhere, and an idle arc of the least radius closes the rim.
bool closes(const ArmFunction& arm, const CamOptions& options) {
    constexpr std::size_t kContacts = 200;
    const std::vector<Contact> contacts = scan_contacts(arm, options, kContacts);
    if (!std::all_of(contacts.begin(), contacts.end(), [](const Contact& c) { return c.path.rho > 0.0; })) return false;
    const bool rising = options.torque_sign > 0;
    const PathPoint &low = (rising ? contacts.front() : contacts.back()).path, &high = (rising ? contacts.back() : contacts.front()).path;
    const double idle = core::kTurn - (high.psi - low.psi);
    return idle > kLeastIdleArc &&
           IdleArc::close({high.h, high.slope, high.rho}, {low.h, low.slope, low.rho}, idle, {options.path.min_idle_curvature_radius, 0.0});
}

}  // namespace

void validate_roller(PartKind kind, const CamOptions& options) {
    const Roller& r = options.roller;
    if (kind == PartKind::kSeries) throw core::InvalidInput("k_se.family", "roller", "cable: a spool pays out a cable");
    if (options.path.kind != PathKind::kPlanar) throw core::InvalidInput("k_pe.path.kind", "helix", "planar: a roller runs on one rim");
    if (options.cable_diameter != 0.0)
        throw core::InvalidInput("cable.diameter_mm", fmt::format("{}", mm_from_m(options.cable_diameter)), "0 on a roller cam");
    core::require_positive("k_pe.roller.radius_mm", mm_from_m(r.radius), "mm");
    core::require_positive("k_pe.roller.base_radius_mm", mm_from_m(r.base_radius), "mm");
    core::require_positive("k_pe.roller.width_mm", mm_from_m(r.width), "mm");
    const double widest = mm_from_m(r.base_radius + r.radius);
    if (!(std::abs(mm_from_m(r.offset)) < widest))
        throw core::InvalidInput("k_pe.roller.offset_mm", fmt::format("{}", mm_from_m(r.offset)),
                                 fmt::format("less than base and roller radius together, {:.4g} mm, on either side", widest));
}

core::Suggestion wider_base(const ArmFunction& arm, const CamOptions& options) {
    constexpr double kGrowth = 1.02, kReserve = 1.002;
    constexpr int kSteps = 233;  // a factor of 100
    CamOptions wider = options;
    for (int i = 1; i <= kSteps; ++i) {
        wider.roller.base_radius = options.roller.base_radius * std::pow(kGrowth, i);
        if (!closes(arm, wider)) continue;
        const double tenths = std::ceil(mm_from_m(kReserve * wider.roller.base_radius) * 10.0);
        return core::change("k_pe.roller.base_radius_mm", core::number(tenths / 10.0));
    }
    return {};
}

}  // namespace fusee::cam
