#pragma once
#include <cmath>

#include "fusee/cam/cam.h"

namespace fusee::cam {

/// Where the roller's centre is on its path at one cam angle, in the frame of the path's tangent u and v = torque_sign (-u_y, u_x), and how
/// it moves on. For numbers and for boxes.
template <class T>
struct RollerPath {
    T s;               ///< centre along u [m]
    T offset;          ///< e: centre along v [m]
    T drive;           ///< q: what the centre moves per cam angle [m/rad]
    T drive_slope;     ///< dq/da [m/rad^2]
    T ratio;           ///< dy/ds: travel of the spring over that of the centre
    T turned;          ///< direction of u in the world, beyond `direction` [rad]
    T curving;         ///< kappa q: torque_sign times what u turns per cam angle
    double direction;  ///< [rad]
};

/// The lengths of an arm's linkage that do not change: docs/theory/roller.md, eq. 6.
struct Linkage {
    double seat;                   ///< pivot to the spring's pin on the frame [m]
    double sin_sum, cos_sum, sum;  ///< of A_0 + B_0 [rad]
    int lead;                      ///< j: torque_sign times the side

    Linkage(const Roller& roller, int torque_sign)
        : seat(std::hypot(roller.arm.lever, roller.arm.spring)),
          sum(arm_start(roller) + std::atan2(roller.arm.spring, roller.arm.lever)),
          lead(torque_sign * roller.arm.side) {
        sin_sum = std::sin(sum), cos_sum = std::cos(sum);
    }
};

/// The roller on an arm: docs/theory/roller.md, eq. 6 and 7. NaN, of a box no bounds, where the spring's pins cannot be so near or far.
template <class T, class Arm>
RollerPath<T> swung(const Arm& arm, const CamOptions& options) {
    using std::sqrt, std::acos;
    const Roller& roller = options.roller;
    const FollowerArm& a = roller.arm;
    const Linkage fixed(roller, options.torque_sign);
    const T apart = a.spring - arm.travel;  // the spring's pins
    const T cos_b = (a.lever * a.lever + fixed.seat * fixed.seat - apart * apart) / (2.0 * a.lever * fixed.seat);
    const T sin_b = sqrt(1.0 - cos_b * cos_b);
    const T lever = a.lever * fixed.seat * sin_b / apart;  // from the pivot to the spring's line
    const T bend = (a.lever * fixed.seat * cos_b / lever - lever) / (apart * lever);
    const T sin_a = fixed.sin_sum * cos_b - fixed.cos_sum * sin_b, cos_a = fixed.cos_sum * cos_b + fixed.sin_sum * sin_b;
    RollerPath<T> path;
    path.ratio = lever / a.length;
    path.s = a.pivot * sin_a;
    path.offset = fixed.lead * (a.length - a.pivot * cos_a);
    path.drive = arm.arm / path.ratio;
    path.drive_slope = (arm.slope + arm.arm * arm.arm * bend) / path.ratio;
    path.turned = static_cast<double>(a.side) * acos(cos_b);
    path.curving = -fixed.lead / a.length * path.drive;
    path.direction = roller.direction + core::kPi - a.side * (fixed.sum + 0.5 * core::kPi);
    return path;
}

/// The follower at one cam angle: the common terms of eq. 1 to 4. For numbers and for boxes.
template <class T>
struct Follower {
    RollerPath<T> path;
    T across;   ///< q - e
    T squared;  ///< L^2 = s^2 + (q - e)^2
    T length;   ///< L [m]: from the roller's centre to the instant centre
    T bend;     ///< L^2 w - L^2: what the pitch curve bends beside a circle about the instant centre

    template <class Arm>
    Follower(const Arm& arm, const CamOptions& options)
        : path(options.roller.follower == FollowerKind::kArm ? swung<T>(arm, options) : slid(arm, options.roller)),
          across(path.drive - path.offset),
          squared(path.s * path.s + across * across),
          length(root(squared)),
          bend(across * path.drive * (1.0 + path.curving)) {}

private:
    template <class Arm>
    static RollerPath<T> slid(const Arm& arm, const Roller& roller) {
        return {arm.travel + follower_start(roller), T(roller.offset), arm.arm, arm.slope, T(1.0), T(0.0), T(0.0), roller.direction};
    }
    static T root(const T& x) {
        using std::sqrt;
        return sqrt(x);
    }
};

/// L/w: radius of curvature of the roller centre's curve (docs/theory/roller.md, eq. 4, 8).
template <class T>
T rolled_pitch_radius(const Follower<T>& f) {
    return f.length * f.squared / (f.squared + f.bend - f.path.drive_slope * f.path.s);
}

/// The contact of a roller with its cam: docs/theory/roller.md, eq. 2 to 4 and 8.
template <class Touch, class Arm>
Touch rolled(const Arm& arm, const CamOptions& options) {
    using std::acos;
    using T = decltype(arm.arm);
    const Roller& roller = options.roller;
    const double ts = options.torque_sign;
    const Follower<T> f(arm, options);
    const RollerPath<T>& at = f.path;
    Touch contact;
    contact.arm = arm;
    contact.path.psi = at.direction - ts * core::kPi / 2.0 + ts * (arm.angle + acos(f.across / f.length)) + at.turned;
    contact.path.h = (at.s * at.s - at.offset * f.across) / f.length - roller.radius;
    contact.path.slope = ts * at.s * at.drive / f.length;
    contact.path.rho = rolled_pitch_radius(f) - roller.radius;
    return contact;
}

}  // namespace fusee::cam
