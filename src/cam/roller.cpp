#include <cmath>

#include "fusee/cam/cam.h"
#include "fusee/core/change.h"
#include "fusee/core/units.h"
#include "rolled.h"

namespace fusee::cam {

namespace {

double square(double x) { return x * x; }

}  // namespace

const char* to_string(Family family) { return family == Family::kCable ? "cable" : "roller"; }

double follower_start(const Roller& roller) {
    const double centre = roller.base_radius + roller.radius;
    return std::sqrt(centre * centre - roller.offset * roller.offset);
}

double arm_start(const Roller& roller) {
    const FollowerArm& arm = roller.arm;
    const double centre = roller.base_radius + roller.radius;
    return std::acos((square(arm.length) + square(arm.pivot) - square(centre)) / (2.0 * arm.length * arm.pivot));
}

Roller with_base(Roller roller, double base_radius) {
    const double before = roller.base_radius + roller.radius, centre = base_radius + roller.radius;
    roller.base_radius = base_radius;
    if (roller.follower == FollowerKind::kSlide) return roller;
    FollowerArm& arm = roller.arm;
    const double cosine = (square(before) + square(arm.length) - square(arm.pivot)) / (2.0 * before * arm.length);
    arm.pivot = std::sqrt(square(centre) + square(arm.length) - 2.0 * centre * arm.length * cosine);
    return roller;
}

core::Suggestion base_change(const Roller& roller, const std::string& base_mm) {
    core::Suggestion wider = core::change("k_pe.roller.base_radius_mm", base_mm);
    if (roller.follower == FollowerKind::kSlide) return wider;
    const Roller moved = with_base(roller, core::m_from_mm(std::stod(base_mm)));
    return wider.with("k_pe.roller.pivot_mm", core::number(core::mm_from_m(moved.arm.pivot)));
}

double spring_ratio(const ArmPoint& arm, const CamOptions& options) { return Follower<double>(arm, options).path.ratio; }

double pressure_angle(const ArmPoint& arm, const CamOptions& options) {
    const Follower<double> f(arm, options);
    return std::atan2(f.across, f.path.s);
}

double pitch_radius(const ArmPoint& arm, const CamOptions& options) { return rolled_pitch_radius(Follower<double>(arm, options)); }

double rim_force(const ArmPoint& arm, const CamOptions& options) {
    return spring_ratio(arm, options) * arm.tension / std::cos(pressure_angle(arm, options));
}

double guide_friction(const ArmPoint& arm, const CamOptions& options, double coefficient) {
    const Follower<double> f(arm, options);
    if (options.roller.follower == FollowerKind::kSlide) return coefficient * std::abs(arm.tension * f.across / f.path.s * arm.arm);
    const double load = rim_force(arm, options) + arm.tension, swing = f.path.drive / options.roller.arm.length;
    return coefficient * 0.5 * options.roller.radius * std::abs(load * swing);
}

double contact_pressure(const ArmPoint& arm, const CamOptions& options) {
    const Roller& roller = options.roller;
    const double normal = rim_force(arm, options), rho = pitch_radius(arm, options) - roller.radius;
    return std::sqrt(normal * roller.contact_modulus / (core::kPi * roller.width) * (1.0 / roller.radius + 1.0 / rho));
}

}  // namespace fusee::cam
