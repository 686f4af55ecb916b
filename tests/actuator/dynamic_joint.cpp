#include "actuator/dynamic_joint.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fusee::actuator {

namespace {

using Eigen::Vector3d;

/// One capstan's friction: a bristle that yields.
class Bristle {
public:
    Bristle(const spring::FrictionLaw& law, const DynamicRig& rig)
        : law_(law), stiffness_(rig.bristle_stiffness), damping_(rig.bristle_damping) {}

    /// Friction torque against `speed` under `load`; the bristle goes on by `step`: b' = v - alpha |v| b/yield, implicit in b, since it
    /// relaxes within yield/v, far below the step. It never bends beyond its yield, but a falling load may leave it there.
    double advance(double load, double speed, double step) {
        const double yield = law_.in_motion(load) / stiffness_, before = bend_;
        most_ = std::max(most_, yield);
        const double alpha = share_plastic(speed, yield);
        bend_ = (before + step * speed) / (1.0 + (alpha > 0.0 ? alpha * step * std::abs(speed) / std::max(yield, kLeastYield) : 0.0));
        const double reach = std::max(yield, std::abs(before));
        bend_ = std::clamp(bend_, -reach, reach);
        return stiffness_ * bend_ + damping_ * (bend_ - before) / step;
    }
    [[nodiscard]] double most_bend() const { return most_; }

private:
    static constexpr double kLeastYield = 1e-12;  ///< [rad]

    /// alpha of Dupont et al., eq. 8: elastic up to 0.7 of the yield, plastic from there on.
    [[nodiscard]] double share_plastic(double speed, double yield) const {
        const double size = std::abs(bend_), begin = 0.7 * yield;
        if (speed * bend_ <= 0.0 || size <= begin) return 0.0;
        if (size >= yield) return 1.0;
        return 0.5 + 0.5 * std::sin(core::kPi * (size - 0.5 * (yield + begin)) / (yield - begin));
    }

    const spring::FrictionLaw& law_;
    double stiffness_, damping_, bend_ = 0.0, most_ = 0.0;
};

class Simulation {
public:
    Simulation(const Joint& joint, const DynamicRig& rig)
        : joint_(joint), rig_(rig), bristles_{Bristle(joint.gear_friction[0], rig), Bristle(joint.gear_friction[1], rig)} {}

    /// Leads the torques smoothly to `torque` within `seconds`.
    void lead_to(const Vector3d& torque, double seconds) {
        const Vector3d start = torque_;
        const auto steps = static_cast<int>(std::lround(seconds / rig_.step));
        for (int i = 1; i <= steps; ++i) {
            const double s = static_cast<double>(i) / steps;
            torque_ = start + (torque - start) * (s * s * (3.0 - 2.0 * s));
            advance();
        }
    }
    [[nodiscard]] double q() const { return z_[kOutput]; }
    [[nodiscard]] double most_bend() const { return std::max(bristles_[0].most_bend(), bristles_[1].most_bend()); }

private:
    void advance() {
        const Vector3d loads = spring_torques(joint_, z_);
        Vector3d force = torque_ - loads;
        for (const int i : {kAgonist, kAntagonist})
            force[i] -= bristles_[i].advance(loads[i], speed_[i], rig_.step) + rig_.motor_viscous * speed_[i];
        force[kOutput] -= rig_.hand_damping * speed_[kOutput];
        const Vector3d inertia(rig_.motor_inertia, rig_.motor_inertia, rig_.joint_inertia);
        speed_ += rig_.step * force.cwiseQuotient(inertia);
        z_ += rig_.step * speed_;
    }

    const Joint& joint_;
    DynamicRig rig_;
    std::array<Bristle, 2> bristles_;
    Vector3d z_ = Vector3d::Zero(), speed_ = Vector3d::Zero(), torque_ = Vector3d::Zero();
};

}  // namespace

DynamicReading dynamic_release_test(const Joint& joint, double tau, double push_torque, const DynamicRig& rig) {
    Simulation simulation(joint, rig);
    simulation.lead_to({tau, tau, 0.0}, rig.ramp_s);
    simulation.lead_to({tau, tau, 0.0}, rig.rest_s);
    const auto release_from = [&](double push) {
        simulation.lead_to({tau, tau, push}, rig.ramp_s);
        simulation.lead_to({tau, tau, push}, rig.hold_s);
        simulation.lead_to({tau, tau, 0.0}, rig.release_s);
        simulation.lead_to({tau, tau, 0.0}, rig.rest_s);
        return simulation.q();
    };
    DynamicReading reading;
    reading.q_high = release_from(push_torque);
    reading.q_low = release_from(-push_torque);
    reading.presliding = simulation.most_bend() / joint.ratio();
    return reading;
}

}  // namespace fusee::actuator
