#include "fusee/gap/motion.h"

#include <algorithm>
#include <cmath>

namespace fusee::gap {

Motion::Motion(const BuiltRig& rig, double longest_step) : rig_(&rig), longest_step_(longest_step) {}

void Motion::lead_to(const Torques& torques, double seconds) {
    if (seconds <= 0.0) {
        torques_ = torques;
        return;
    }
    const int steps = std::max(1, static_cast<int>(std::ceil(seconds / longest_step_)));
    const Torques from = torques_;
    const bool held = from == torques;
    for (int i = 1; i <= steps && !(held && i > 1 && at_rest()); ++i) {
        const double share = static_cast<double>(i) / steps;
        torques_ = {from.agonist + share * (torques.agonist - from.agonist),
                    from.antagonist + share * (torques.antagonist - from.antagonist), from.joint + share * (torques.joint - from.joint)};
        step(seconds / steps);
    }
}

double Motion::gear_speed(int side, double h, double load, double command) {
    const Gear& gear = rig_->sides[side].gear;
    const double torque = std::clamp(command * (1.0 + gear.torque_scale), -gear.saturation, gear.saturation);
    const double momentum = rig_->motor_inertia * speed_[side] + h * (torque - load);
    const double way = momentum < 0.0 ? -1.0 : 1.0;
    const double sliding =
        (gear.coulomb + gear.load_friction * std::abs(load) + gear.quadratic * load * load) * (1.0 + way * gear.asymmetry);
    const double left = std::abs(momentum) - h * sliding, mass = rig_->motor_inertia + h * gear.viscous;
    if (left <= h * sliding * gear.stribeck) {
        if (left <= 0.0 || speed_[side] * way <= 0.0) return 0.0;
    }
    double speed = left / mass;
    if (gear.stribeck > 0.0)
        for (int i = 0; i < 3; ++i) {
            const double share = speed / gear.stribeck_speed;
            speed = std::max(0.0, (left - h * sliding * gear.stribeck * std::exp(-share * share)) / mass);
        }
    return way * speed;
}

void Motion::step(double h) {
    const double stretch = rig_->ratio * place_[2];
    std::array<double, 2> pull{};
    for (int i = 0; i < 2; ++i) {
        const BuiltSide& side = rig_->sides[i];
        const double theta = place_[i], wound = rig_->capstan_scale * theta, x = i == 0 ? wound + stretch : wound - stretch;
        pull[i] = memory_[2 * i].torque(x, side.se.torque(x), side.se_build.hysteresis);
        const double load =
            rig_->capstan_scale * pull[i] + memory_[2 * i + 1].torque(theta, side.pe.torque(theta), side.pe_build.hysteresis);
        speed_[i] = gear_speed(i, h, load, i == 0 ? torques_.agonist : torques_.antagonist);
    }
    const double inside = std::max(0.0, std::abs(place_[2]) - rig_->stop);
    const double stop = inside > 0.0 ? std::copysign(rig_->stop_stiffness * inside, place_[2]) : 0.0;
    const double damping = inside > 0.0 ? std::sqrt(rig_->stop_stiffness * rig_->joint_inertia) : 0.0;  // half of critical
    const double weight = rig_->gravity == 0.0 ? 0.0 : rig_->gravity * std::sin(place_[2]);
    const double drive = rig_->ratio * (pull[1] - pull[0]) + torques_.joint - weight - stop;
    const double momentum = rig_->joint_inertia * speed_[2] + h * drive;
    const double friction = h * (rig_->joint_coulomb + rig_->tension_friction * rig_->ratio * (pull[0] + pull[1]));
    const double left = std::max(0.0, std::abs(momentum) - friction);
    speed_[2] = std::copysign(left, momentum) / (rig_->joint_inertia + h * (rig_->joint_viscous + hand_damping + damping));
    for (int i = 0; i < 3; ++i) place_[i] += h * speed_[i];
    for (int i = 0; i < 2; ++i)
        if (place_[i] < 0.0) place_[i] = speed_[i] = 0.0;  // the preload stop
}

}  // namespace fusee::gap
