#include "fusee/mjcf/twin.h"

#include <algorithm>
#include <cmath>

namespace fusee::mjcf {

namespace {

constexpr std::size_t kFrictionRows = 201;  ///< of a friction that is no straight line
constexpr double kLoads = 2.0;              ///< they reach so many times the greatest load of the springs
constexpr double kPhase = 0.1;              ///< [rad], of the stiffest motion in one step: 0.1 % in its frequency
constexpr double kStopPhase = 0.5;          ///< [rad], of a spring on its preload stop: stable up to 2
constexpr double kLeastStop = 1e-4;         ///< [rad], as spring::behind_cable

double greatest_load(const TwinSide& side) { return side.se.greatest() + side.pe.greatest(); }

/// Friction over the load as rows; two of them if it is a straight line.
template <class Friction>
void set_rows(TwinGear& gear, double most, bool straight, const Friction& friction) {
    const std::size_t rows = straight ? 2 : kFrictionRows;
    for (std::size_t i = 0; i < rows; ++i) {
        gear.load.push_back(most * static_cast<double>(i) / static_cast<double>(rows - 1));
        gear.friction.push_back(friction(gear.load.back()));
    }
}

/// The greatest angular frequency of a body whose neighbours are held [rad/s].
double fastest(const Twin& twin) {
    double joint = 0.0, most = 0.0;
    for (const TwinSide& side : twin.sides) {
        const double s = side.se.greatest_stiffness(), scale = side.capstan_scale;
        joint += side.ratio * side.ratio * s;
        most = std::max(most, (scale * scale * s + side.pe.greatest_stiffness()) / side.motor_inertia);
    }
    if (std::isfinite(twin.stop)) joint += twin.stop_stiffness;
    return std::sqrt(std::max(most, joint / twin.joint_inertia));
}

/// A preload stop so soft that a step of the simulation resolves it.
double stop_travel(const Twin& twin, const TwinSide& side, const Curve& curve) {
    const double lightest = std::min(side.motor_inertia, twin.joint_inertia / std::max(1.0, side.ratio * side.ratio));
    const double share = time_step(twin) / kStopPhase;
    return std::max(kLeastStop, curve.torque.front() * share * share / lightest);
}

}  // namespace

double TwinGear::at(double at_load) const {
    const double size = std::abs(at_load);
    std::size_t i = 0;
    while (i + 2 < load.size() && size > load[i + 1]) ++i;
    return friction[i] + (friction[i + 1] - friction[i]) * (size - load[i]) / (load[i + 1] - load[i]);
}

double time_step(const Twin& twin) {
    const double longest = kPhase / fastest(twin);
    for (double power = 1e-3; power > 1e-9; power *= 0.1)
        for (const double digit : {1.0, 0.5, 0.2})
            if (digit * power <= longest) return digit * power;
    return longest;
}

Twin twin_of(const actuator::Joint& joint, const TwinMotion& motion) {
    Twin twin;
    twin.capstan_radius = joint.capstan_radius;
    twin.joint_inertia = motion.joint_inertia;
    twin.joint_viscous = motion.joint_viscous;
    twin.joint_friction = joint.output_friction.constant;
    twin.tension_share = joint.output_friction.tension_share;
    twin.reference_torque = motion.reference_torque;
    for (std::size_t i = 0; i < 2; ++i) {
        TwinSide& side = twin.sides[i];  // springs in the order K_PE, K_SE of the agonist, K_SE, K_PE of the antagonist
        side.pe = tabulate(*joint.springs[i == 0 ? 0 : 3].potential, kLeastStop);
        side.se = tabulate(*joint.springs[i == 0 ? 1 : 2].potential, kLeastStop);
        side.ratio = joint.ratio();
        side.motor_inertia = motion.motor_inertia;
        side.gear.viscous = motion.motor_viscous;
        const spring::FrictionLaw& law = joint.gear_friction[i];
        const double most = kLoads * greatest_load(side);
        set_rows(side.gear, most, law.rows().empty(), [&](double load) { return law.in_motion(load); });
        if (const double moving = law.in_motion(most); moving > 0.0)
            side.gear.rest_excess = std::max(0.0, law.at_rest(most) / moving - 1.0);
    }
    for (TwinSide& side : twin.sides)
        for (Curve* curve : {&side.se, &side.pe}) curve->stop_travel = stop_travel(twin, side, *curve);
    return twin;
}

Twin twin_of(const joint_model::BuiltRig& rig, double capstan_radius, double reference_torque) {
    Twin twin;
    twin.capstan_radius = capstan_radius;
    twin.joint_inertia = rig.joint_inertia;
    twin.joint_viscous = rig.joint_viscous;
    twin.joint_friction = rig.joint_coulomb;
    twin.tension_share = rig.tension_friction;
    twin.gravity = rig.gravity;
    twin.stop = rig.stop;
    twin.stop_stiffness = rig.stop_stiffness;
    twin.stop_damping = rig.stop_damping;
    twin.joint_offset = rig.joint_offset;
    twin.delay = rig.delay;
    twin.capstan_stops = true;
    twin.reference_torque = reference_torque;
    for (std::size_t i = 0; i < 2; ++i) {
        const joint_model::BuiltSide& built = rig.sides[i];
        const joint_model::Gear& gear = built.gear;
        TwinSide& side = twin.sides[i];
        side.ratio = built.ratio;
        side.capstan_scale = built.capstan_scale;
        side.motor_inertia = built.motor_inertia;
        side.se = tabulate(built.se, built.se_build.hysteresis);
        side.pe = tabulate(built.pe, built.pe_build.hysteresis);
        side.gear = {.load = {},
                     .friction = {},
                     .asymmetry = gear.asymmetry,
                     .rest_excess = gear.stribeck,
                     .rest_speed = gear.stribeck_speed,
                     .viscous = gear.viscous,
                     .torque_scale = 1.0 + gear.torque_scale,
                     .saturation = gear.saturation,
                     .backlash = gear.backlash};
        set_rows(side.gear, kLoads * greatest_load(side), gear.quadratic == 0.0,
                 [&](double load) { return gear.coulomb + load * (gear.load_friction + gear.quadratic * load); });
    }
    return twin;
}

}  // namespace fusee::mjcf
