#pragma once
#include <cmath>

#include "fusee/cam/cam.h"

namespace fusee::cam {

/// The follower at one cam angle: the common terms of eq. 1 to 4. For numbers and for boxes.
template <class T>
struct Follower {
    T s;        ///< roller centre along the follower's line [m]
    T across;   ///< r - e [m]
    T squared;  ///< L^2 = s^2 + (r - e)^2
    T length;   ///< L [m]: from the roller's centre to the instant centre

    template <class Arm>
    Follower(const Arm& arm, const Roller& roller)
        : s(arm.travel + follower_start(roller)),
          across(arm.arm - roller.offset),
          squared(s * s + across * across),
          length(root(squared)) {}

private:
    static T root(const T& x) {
        using std::sqrt;
        return sqrt(x);
    }
};

/// L/(1 - dphi/da): radius of curvature of the roller centre's curve (docs/theory/roller.md, eq. 4).
template <class T, class Arm>
T rolled_pitch_radius(const Follower<T>& f, const Arm& arm) {
    return f.length * f.squared / (f.squared + f.across * arm.arm - arm.slope * f.s);
}

/// The contact of a roller with its cam: docs/theory/roller.md, eq. 2 to 4.
template <class Touch, class Arm>
Touch rolled(const Arm& arm, const CamOptions& options) {
    using std::acos;
    using T = decltype(arm.arm);
    const Roller& roller = options.roller;
    const double ts = options.torque_sign;
    const Follower<T> f(arm, roller);
    Touch contact;
    contact.arm = arm;
    contact.path.psi = roller.direction - ts * core::kPi / 2.0 + ts * (arm.angle + acos(f.across / f.length));
    contact.path.h = (f.s * f.s - roller.offset * f.across) / f.length - roller.radius;
    contact.path.slope = ts * f.s * arm.arm / f.length;
    contact.path.rho = rolled_pitch_radius(f, arm) - roller.radius;
    return contact;
}

}  // namespace fusee::cam
