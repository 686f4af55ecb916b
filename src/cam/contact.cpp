#include "fusee/cam/contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "enclosure.h"
#include "rolled.h"

namespace fusee::cam {

namespace {

/// Distance of the cable's line from the axis when the idler's centre is put on the line: c = r + sR. The centre lies on the cam's side of
/// the cable (s = -1) if the cable turns idler and cam in the same sense.
template <class T>
T offset_arm(const T& arm, const CamOptions& options) {
    const Guide& guide = options.guide;
    return guide.kind == GuideKind::kIdler ? arm - options.torque_sign * guide.sense * guide.radius : arm;
}

/// Eq. 3 to 7, for numbers and for boxes. @pre a tangent exists
template <class Touch, class Arm>
Touch touched(PartKind kind, const Arm& arm, const CamOptions& options) {
    using std::sqrt, std::acos, math::cube;
    using T = decltype(arm.arm);
    const double sigma = winding_sign(kind), ts = options.torque_sign;
    const T turned = static_cast<double>(rotation_sign(kind, options.torque_sign)) * arm.angle;
    Touch contact;
    contact.arm = arm;
    auto& path = contact.path;
    path.h = arm.arm;
    if (options.guide.kind == GuideKind::kParallel) {
        path.psi = options.guide.direction - ts * core::kPi / 2.0 - turned;
        path.slope = sigma * ts * arm.slope;
        path.rho = arm.arm + arm.second_derivative;
        return contact;
    }
    const double distance = options.guide.distance;
    const T c = offset_arm(arm.arm, options);
    const T span = sqrt(distance * distance - c * c);  // NaN if the guide is nearer than the arm
    const T w = 1.0 + sigma * arm.slope / span;
    path.psi = options.guide.direction - ts * acos(c / distance) - turned;
    path.slope = sigma * ts * arm.slope / w;
    path.rho = arm.arm + (arm.second_derivative - sigma * c * cube(arm.slope / span)) / cube(w);
    contact.span = span * span / (span + sigma * arm.slope);
    return contact;
}

/// Of a roller's arm: how far the spring's pins are from their nearest and farthest places, the lever of its spring, and the distance at
/// which the roller's path passes the axis.
double follower_margin(const ArmPoint& arm, const CamOptions& options) {
    if (options.roller.follower == FollowerKind::kSlide) return std::numeric_limits<double>::infinity();
    const FollowerArm& a = options.roller.arm;
    const double seat = Linkage(options.roller, options.torque_sign).seat, pins = a.spring - arm.travel;
    const double room = std::min(pins - std::abs(seat - a.lever), seat + a.lever - pins);
    if (!(room > 0.0)) return room;
    const RollerPath<double> path = swung<double>(arm, options);
    return path.s > 0.0 ? path.ratio * options.roller.arm.length : path.s;
}

}  // namespace

int winding_sign(PartKind kind) { return kind == PartKind::kParallel ? 1 : -1; }

int rotation_sign(PartKind kind, int torque_sign) { return kind == PartKind::kSeries ? torque_sign : -torque_sign; }

double guide_margin(PartKind kind, const ArmPoint& arm, const CamOptions& options) {
    if (options.family == Family::kRoller) return follower_margin(arm, options);
    if (options.guide.kind == GuideKind::kParallel) return std::numeric_limits<double>::infinity();
    const double c = offset_arm(arm.arm, options), distance = options.guide.distance;
    if (std::abs(c) >= distance) return distance - std::abs(c);
    return std::min(distance - std::abs(c), std::sqrt(distance * distance - c * c) + winding_sign(kind) * arm.slope);
}

Contact touch(PartKind kind, const ArmPoint& arm, const CamOptions& options) {
    if (options.family == Family::kRoller) return rolled<Contact>(arm, options);
    Contact contact = touched<Contact>(kind, arm, options);
    if (guide_margin(kind, arm, options) <= 0.0) contact.path.rho = std::numeric_limits<double>::quiet_NaN();
    return contact;
}

// For boxes beyond the guide the square root has already removed the bounds.
ContactJet touch(PartKind kind, const ArmJet& arm, const CamOptions& options) {
    if (options.family == Family::kRoller) return rolled<ContactJet>(arm, options);
    ContactJet contact = touched<ContactJet>(kind, arm, options);
    if (options.guide.kind != GuideKind::kParallel && !(contact.span.value.lower() > 0.0)) contact.path.rho = math::Jet::anything();
    return contact;
}

}  // namespace fusee::cam
