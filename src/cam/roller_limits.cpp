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

void validate_arm(const Roller& r, const spring::BaseSpring& spring) {
    const FollowerArm& arm = r.arm;
    core::require_positive("k_pe.roller.arm_mm", mm_from_m(arm.length), "mm");
    core::require_positive("k_pe.roller.pivot_mm", mm_from_m(arm.pivot), "mm");
    core::require_positive("k_pe.roller.lever_mm", mm_from_m(arm.lever), "mm");
    core::require_positive("k_pe.roller.spring_mm", mm_from_m(arm.spring), "mm");
    const double centre = r.base_radius + r.radius, least = std::abs(centre - arm.length), most = centre + arm.length;
    if (!(least < arm.pivot && arm.pivot < most))
        throw core::InvalidInput("k_pe.roller.pivot_mm", fmt::format("{:.6g}", mm_from_m(arm.pivot)),
                                 fmt::format("between {:.4g} and {:.4g} mm, where an arm of {:.4g} mm holds the roller {:.4g} mm from the "
                                             "axis: its base and its own radius",
                                             mm_from_m(least), mm_from_m(most), mm_from_m(arm.length), mm_from_m(centre)));
    const double coils = spring.free_length - spring.preload;  // both shorten by the same travel
    if (arm.spring < coils)
        throw core::InvalidInput("k_pe.roller.spring_mm", fmt::format("{:.6g}", mm_from_m(arm.spring)),
                                 fmt::format("at least {:.4g} mm, the length of the coils under their preload", mm_from_m(coils)));
}

}  // namespace

void validate_roller(const ArmFunction& function, const CamOptions& options) {
    const Roller& r = options.roller;
    if (function.kind() == PartKind::kSeries) throw core::InvalidInput("k_se.family", "roller", "cable: a spool pays out a cable");
    if (options.path.kind != PathKind::kPlanar) throw core::InvalidInput("k_pe.path.kind", "helix", "planar: a roller runs on one rim");
    if (options.cable_diameter != 0.0)
        throw core::InvalidInput("cable.diameter_mm", fmt::format("{}", mm_from_m(options.cable_diameter)), "0 on a roller cam");
    core::require_positive("k_pe.roller.radius_mm", mm_from_m(r.radius), "mm");
    core::require_positive("k_pe.roller.base_radius_mm", mm_from_m(r.base_radius), "mm");
    core::require_positive("k_pe.roller.width_mm", mm_from_m(r.width), "mm");
    if (r.follower == FollowerKind::kArm) return validate_arm(r, function.base());
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
        wider.roller = with_base(options.roller, options.roller.base_radius * std::pow(kGrowth, i));
        if (!closes(arm, wider)) continue;
        const double tenths = std::ceil(mm_from_m(kReserve * wider.roller.base_radius) * 10.0);
        return base_change(options.roller, core::number(tenths / 10.0));
    }
    return {};
}

}  // namespace fusee::cam
