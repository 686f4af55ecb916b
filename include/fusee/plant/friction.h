#pragma once
#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"
#include "fusee/plant/rig.h"

namespace fusee::plant {

/// Friction with presliding: bristles of deflection z, elastic up to the friction in motion, then sliding,
///     f = s0 z + s1 dz/dt,   dz/dt = v (1 - a(z, v) |z| / z_ss),   z_ss = f_slide/s0
/// a = 1 always: LuGre (Canudas de Wit, Olsson, Astrom & Lischinsky 1995), which creeps under a shaking load below the limit; a = 0 up to
/// a break-away bend of 0.7 z_ss: the elasto-plastic model (Dupont, Hayward, Armstrong & Altpeter 2002), which does not.
class Bristles {
public:
    Bristles(Presliding kind, double stiffness, double damping) : kind_(kind), stiffness_(stiffness), damping_(damping) {}
    /// Friction torque [Nm] against the velocity, of the state after the last step.
    [[nodiscard]] double torque() const { return stiffness_ * bend_ + damping_ * rate_; }
    /// A step at velocity v [rad/s]; `sliding` >= 0 is the friction in steady motion [Nm] at this speed and load. Sliding is taken
    /// implicitly: stable at any speed.
    void step(double v, double sliding, double dt) {
        const double steady = std::max(sliding / stiffness_, kLeastBend);
        const double before = bend_;
        bend_ = (bend_ + v * dt) / (1.0 + sliding_share(v, steady) * std::abs(v) * dt / steady);
        rate_ = (bend_ - before) / dt;
    }
    [[nodiscard]] double stored() const { return 0.5 * stiffness_ * bend_ * bend_; }  ///< energy in the bristles [J]

private:
    [[nodiscard]] double sliding_share(double v, double steady) const {
        constexpr double kBreakAway = 0.7;
        if (kind_ == Presliding::kLuGre) return 1.0;
        if (v * bend_ < 0.0) return 0.0;
        const double bent = std::abs(bend_) / steady;
        if (bent <= kBreakAway) return 0.0;
        if (bent >= 1.0) return 1.0;
        return 0.5 + 0.5 * std::sin(core::kPi * ((bent - kBreakAway) / (1.0 - kBreakAway) - 0.5));
    }

    static constexpr double kLeastBend = 1e-9;  // [rad]
    Presliding kind_;
    double stiffness_, damping_, bend_ = 0.0, rate_ = 0.0;
};

/// Gear friction of a side in steady motion [Nm], without its viscous part: (mu load + constant) times what angle, session and speed make
/// of it. At speed 0 it is the friction at rest.
/// @param warm drift's factor at this time of the session
[[nodiscard]] inline double gear_friction(const SideTruth& side, double load, double theta, double speed, double warm) {
    double friction = (side.mu * std::max(load, 0.0) + side.coulomb) * warm;
    if (side.ripple != 0.0) friction *= 1.0 + side.ripple * std::sin(side.ripple_turns * theta + side.ripple_phase);
    if (side.stribeck != 0.0) {
        const double share = speed / side.stribeck_speed;
        friction *= 1.0 + side.stribeck * std::exp(-share * share);
    }
    return friction;
}
/// 1 + drift (1 - exp(-t/time)).
[[nodiscard]] inline double warmth(const SideTruth& side, double session) {
    return side.drift == 0.0 ? 1.0 : 1.0 + side.drift * -std::expm1(-session / side.drift_time);
}

}  // namespace fusee::plant
