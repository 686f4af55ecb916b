#pragma once
#include <array>
#include <cmath>

#include "fusee/plant/friction.h"
#include "fusee/plant/spring.h"

namespace fusee::plant {

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

/// The joint in time: two motors with gears and a joint of inertia, cables that cannot push, stops,
///     I theta_i'' = tau_i - F_PE - F_SE(x_i) - friction - viscous - stop
///     J q''       = tau_q + g (F_SE(x_2) - F_SE(x_1)) - friction - viscous - gravity - stop - harness
/// by steps of kStep, semi-implicit (velocities first). Starts at rest with every cable just taut.
class Machine {
public:
    static constexpr double kStep = 1e-4;  ///< [s]
    /// @param session time since the rig was switched on [s]
    Machine(const Truth& truth, const BuiltSprings& springs, double session);

    void step(const Command& command);
    /// `command(t)` for t in (0, seconds]; takes whole steps.
    template <class CommandAt>
    void run(double seconds, const CommandAt& command) {
        const long steps = std::lround(seconds / kStep);
        for (long i = 1; i <= steps; ++i) step(command(static_cast<double>(i) * kStep));
        warm_up();
    }
    [[nodiscard]] double theta(std::size_t side) const { return sides_[side].theta; }
    [[nodiscard]] double q() const { return q_; }
    [[nodiscard]] double joint_torque() const { return joint_torque_; }  ///< of the last command [Nm]
    [[nodiscard]] double session() const { return session_; }
    /// Kinetic, of springs and of bristles [J], for springs without memory and a joint without stop, gravity and harness.
    [[nodiscard]] double energy() const;
    void push_joint(double speed) { joint_speed_ = speed; }  ///< gives it a speed [rad/s]

private:
    struct Side {
        Bristles gear;
        Spring se, pe;
        double theta = 0.0, speed = 0.0, warm = 1.0, slipped = 0.0;
        bool jumped = false;
    };
    [[nodiscard]] static Side side_of(const Truth& truth, const BuiltSprings& springs, std::size_t i);
    [[nodiscard]] double cable(std::size_t i);
    void turn_motor(std::size_t i, double series, const Command& command);
    void turn_joint(const std::array<double, 2>& series, const Command& command);
    void warm_up();

    Truth truth_;
    std::array<Side, 2> sides_;
    Bristles bearing_;
    double q_ = 0.0, joint_speed_ = 0.0, joint_torque_ = 0.0, session_ = 0.0;
};

}  // namespace fusee::plant
