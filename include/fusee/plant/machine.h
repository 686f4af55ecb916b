#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

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
    if (side.rise != 0.0) friction *= 1.0 + side.rise * speed / (speed + side.rise_speed);
    if (side.stribeck != 0.0) {
        const double share = speed / side.stribeck_speed;
        friction *= 1.0 + side.stribeck * std::exp(-share * share);
    }
    return friction;
}
/// share (1 - exp(-t/time)): what changes with the session's time t.
[[nodiscard]] inline double settled(double share, double time, double session) {
    return share == 0.0 ? 0.0 : share * -std::expm1(-session / time);
}
/// share t/(t + time): what warms slower and slower. A term of the diagnosis has its place and its variable, none has this law.
[[nodiscard]] inline double warmed(double share, double time, double session) { return share * session / (session + time); }
[[nodiscard]] inline double warmth(const SideTruth& side, double session) { return 1.0 + settled(side.drift, side.drift_time, session); }
/// Torque of a fluid against the joint's motion [Nm]: viscous below about 1 rad/s, quadratic in the speed [rad/s] above; no power of it.
[[nodiscard]] inline double fluid_drag(double drag, double speed) {
    constexpr double kLaminar = 1.0;  // [rad/s]
    return drag * std::hypot(speed, kLaminar) * speed;
}
/// Torque of a motor at this time of the session [Nm], without the other's crosstalk and cogging.
[[nodiscard]] inline double delivered(const SideTruth& side, double command, double session) {
    const double torque = side.torque_scale * (1.0 + warmed(side.fade, side.fade_time, session)) * command;
    return side.saturation == kNever ? torque : torque / std::hypot(1.0, torque / side.saturation);
}

/// Torque over deflection on an even grid; 0 for a slack cable, straight on beyond the last row.
class TorqueTable {
public:
    TorqueTable() = default;
    /// @pre x ascends from 0 (equal neighbours allowed), as many torques
    TorqueTable(const std::vector<double>& x, const std::vector<double>& torque);
    [[nodiscard]] double at(double x) const {
        if (x <= 0.0) return 0.0;
        const double place = x * per_step_;
        const auto row = static_cast<std::size_t>(place < last_ ? place : last_);
        const double torque = torque_[row] + (place - static_cast<double>(row)) * (torque_[row + 1] - torque_[row]);
        return x < kTaut ? torque * (x / kTaut) : torque;
    }

private:
    static constexpr double kTaut = 0.004;  // [rad] over which a preloaded spring leaves its stop: the stop is not rigid
    std::vector<double> torque_;
    double per_step_ = 0.0, last_ = 0.0;
};

/// K_SE as built: spool angle phi with 1/2 k_t phi^2 = U and arm r(phi) = k_t phi r_c/F of the drawing; then cable length s = integral of
/// the arms as cut, F = k_t (phi + phi0) r_c/r and deflection s/r_c + F/(cable stiffness).
[[nodiscard]] TorqueTable build_series(const Nominal& nominal, const SideTruth& side);
/// K_PE as built: compression y with 1/2 k y^2 = U and arm r(theta) = tau/(k y) of the drawing; then y = integral of the arms as cut and
/// F = k (y + y0) r, far steeper once it binds.
[[nodiscard]] TorqueTable build_parallel(const Nominal& nominal, const SideTruth& side);

/// A built spring with hysteresis and creep. Starts at rest, unloaded.
class Spring {
public:
    Spring(TorqueTable table, const SpringTruth& truth) : table_(std::move(table)), truth_(truth) {}
    /// Torque [Nm] at a deflection `dt` after the last one.
    [[nodiscard]] double pull(double deflection, double dt);
    [[nodiscard]] const TorqueTable& table() const { return table_; }
    void warm_up(double session) { warm_ = 1.0 + warmed(truth_.warm_share, truth_.warm_time, session); }

private:
    TorqueTable table_;
    SpringTruth truth_;
    double warm_ = 1.0, last_ = 0.0, turned_ = 0.0, relaxed_ = 0.0;
};

inline double Spring::pull(double deflection, double dt) {
    double torque = warm_ * table_.at(deflection);
    if (truth_.hysteresis != 0.0) {
        const double bend = (deflection - last_) / truth_.hysteresis_reach;
        turned_ = (turned_ + bend) / (1.0 + (bend < 0.0 ? -bend : bend));
        torque *= 1.0 + truth_.hysteresis * turned_;
    }
    last_ = deflection;
    if (truth_.creep_share != 0.0) {
        relaxed_ += (torque - relaxed_) * dt / truth_.creep_time;
        torque += truth_.creep_share * (torque - relaxed_);
        if (torque < 0.0) torque = 0.0;
    }
    return torque;
}

/// Applied torques.
struct Command {
    std::array<double, 2> motor{};  ///< agonist, antagonist [Nm at the capstan]
    double joint = 0.0;             ///< [Nm]
    double hand = 0.0;              ///< damping by hand at the joint [Nms]
};

/// The springs of a rig as built; the same for every run.
struct BuiltSprings {
    std::array<TorqueTable, 2> se, pe;
    explicit BuiltSprings(const Nominal& nominal, const Truth& truth);
};

/// Springs, cables and motors of a rig as built, and the limits of its friction: what an engine does not move. Steps of `dt` [s].
class Drive {
public:
    /// @param session time since the rig was switched on [s]
    Drive(const Truth& truth, const BuiltSprings& springs, double session);

    /// Pull of K_SE [Nm at the capstan] at these angles. The cable may slip or jump. Once a step.
    [[nodiscard]] double series(std::size_t side, double theta, double q, double dt);
    /// Pull of K_PE [Nm]. Once a step.
    [[nodiscard]] double parallel(std::size_t side, double theta, double dt) { return sides_[side].pe.pull(theta, dt); }
    /// Torque of a motor [Nm].
    [[nodiscard]] double motor(std::size_t side, const std::array<double, 2>& command, double theta) const;
    /// Friction of a gear in steady motion [Nm], of the joint's bearing under both cables' pull at the joint [Nm].
    [[nodiscard]] double gear_limit(std::size_t side, double load, double theta, double speed) const {
        return gear_friction(truth_.sides[side], load, theta, speed, sides_[side].warm);
    }
    [[nodiscard]] double bearing_limit(double q, double pulls) const;
    /// Ends a step: the mount follows these pulls of both cables [Nm].
    void end_step(const std::array<double, 2>& series, double dt);
    /// Ends a run: springs and gears have warmed up by now.
    void warm_up();
    [[nodiscard]] const TorqueTable& series_table(std::size_t side) const { return sides_[side].se.table(); }
    [[nodiscard]] const TorqueTable& parallel_table(std::size_t side) const { return sides_[side].pe.table(); }
    [[nodiscard]] double slipped(std::size_t side) const { return sides_[side].slipped; }  ///< [rad]
    [[nodiscard]] double session() const { return session_; }
    [[nodiscard]] const Truth& truth() const { return truth_; }

private:
    struct Side {
        Spring se, pe;
        double warm = 1.0, slipped = 0.0;
        bool jumped = false;
    };
    Truth truth_;
    std::array<Side, 2> sides_;
    double bent_ = 0.0, session_;
};

/// The rig with springs that lose nothing: for an engine whose own friction along the cable their hysteresis is.
[[nodiscard]] Truth without_hysteresis(Truth truth);

/// A rig in motion: at rest at first, every cable just taut.
class Motion {
public:
    virtual ~Motion() = default;

    /// `command(t)` for t in (0, seconds]; takes whole steps.
    virtual void run(double seconds, const std::function<Command(double)>& command) = 0;
    [[nodiscard]] virtual double theta(std::size_t side) const = 0;  ///< of a capstan [rad]
    [[nodiscard]] virtual double q() const = 0;                      ///< [rad]
    [[nodiscard]] virtual double joint_torque() const = 0;           ///< of the last command [Nm]
    [[nodiscard]] virtual double session() const = 0;                ///< time since the rig was switched on [s]
};

/// What moves a rig: the plant's own laws of motion and friction, or those of another engine.
class Engine {
public:
    virtual ~Engine() = default;

    /// @param session time since the rig was switched on [s]
    [[nodiscard]] virtual std::unique_ptr<Motion> start(const Truth& truth, const BuiltSprings& springs, double session) const;
    /// The load [Nm] at which a capstan held at `theta` starts to turn, motor torque held; its friction is `scatter` times that of the rig.
    [[nodiscard]] virtual double break_away(const SideTruth& side, double motor, bool backdrive, double theta, double scatter,
                                            double session) const;
};

/// The joint in time: two motors with gears and a joint of inertia, cables that cannot push, stops,
///     I theta_i'' = tau_i - F_PE - F_SE(x_i) - friction - viscous - stop
///     J q''       = tau_q + g (F_SE(x_2) - F_SE(x_1)) - friction - viscous - drag - gravity - stop - harness
/// by steps of kStep, semi-implicit (velocities first).
class Machine final : public Motion {
public:
    static constexpr double kStep = 1e-4;  ///< [s]
    /// @param session time since the rig was switched on [s]
    Machine(const Truth& truth, const BuiltSprings& springs, double session);

    void step(const Command& command);
    void run(double seconds, const std::function<Command(double)>& command) override;
    [[nodiscard]] double theta(std::size_t side) const override { return sides_[side].theta; }
    [[nodiscard]] double q() const override { return q_; }
    [[nodiscard]] double joint_torque() const override { return joint_torque_; }
    [[nodiscard]] double session() const override { return drive_.session(); }
    /// Kinetic, of springs and of bristles [J], for springs without memory and a joint without stop, gravity and harness.
    [[nodiscard]] double energy() const;
    void push_joint(double speed) { joint_speed_ = speed; }  ///< gives it a speed [rad/s]

private:
    struct Side {
        Bristles gear;
        double theta = 0.0, speed = 0.0;
    };
    void turn_motor(std::size_t i, double series, const Command& command);
    void turn_joint(const std::array<double, 2>& series, const Command& command);

    Drive drive_;
    std::array<Side, 2> sides_;
    Bristles bearing_;
    double q_ = 0.0, joint_speed_ = 0.0, joint_torque_ = 0.0;
};

}  // namespace fusee::plant
