#include "fusee/cam/contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fusee::cam {

namespace {

/// Distance of the cable's line from the axis when the idler's centre is put on the line: c = r + sR. The centre lies on the cam's side of
/// the cable (s = -1) when the cable turns idler and cam the same way.
double offset_arm(const ArmPoint& arm, const CamOptions& options) {
    const Guide& guide = options.guide;
    return guide.kind == GuideKind::kIdler ? arm.arm - options.torque_sign * guide.sense * guide.radius : arm.arm;
}

}  // namespace

int winding_sign(PartKind kind) { return kind == PartKind::kParallel ? 1 : -1; }

int rotation_sign(PartKind kind, int torque_sign) { return kind == PartKind::kSeries ? torque_sign : -torque_sign; }

double guide_reach(PartKind kind, const ArmPoint& arm, const CamOptions& options) {
    if (options.guide.kind == GuideKind::kParallel) return std::numeric_limits<double>::infinity();
    const double c = offset_arm(arm, options), distance = options.guide.distance;
    if (std::abs(c) >= distance) return distance - std::abs(c);
    return std::min(distance - std::abs(c), std::sqrt(distance * distance - c * c) + winding_sign(kind) * arm.slope);
}

Contact touch(PartKind kind, const ArmPoint& arm, const CamOptions& options) {
    const double sigma = winding_sign(kind), ts = options.torque_sign;
    const double turned = rotation_sign(kind, options.torque_sign) * arm.angle;
    Contact contact;
    contact.arm = arm;
    PathPoint& path = contact.path;
    path.h = arm.arm;
    if (options.guide.kind == GuideKind::kParallel) {
        path.psi = options.guide.direction - ts * core::kPi / 2.0 - turned;
        path.slope = sigma * ts * arm.slope;
        path.rho = arm.arm + arm.bend;
        return contact;
    }
    const double c = offset_arm(arm, options), distance = options.guide.distance;
    const double span = std::sqrt(distance * distance - c * c);  // NaN where the guide is nearer than the arm
    const double w = 1.0 + sigma * arm.slope / span;
    path.psi = options.guide.direction - ts * std::acos(c / distance) - turned;
    path.slope = sigma * ts * arm.slope / w;
    path.rho = arm.arm + (arm.bend - sigma * c * std::pow(arm.slope / span, 3)) / std::pow(w, 3);
    contact.span = span * span / (span + sigma * arm.slope);
    if (guide_reach(kind, arm, options) <= 0.0) path.rho = std::numeric_limits<double>::quiet_NaN();
    return contact;
}

}  // namespace fusee::cam
