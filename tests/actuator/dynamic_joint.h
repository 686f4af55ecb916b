#pragma once
#include "fusee/actuator/joint.h"

namespace fusee::actuator {

/// A rig with mass, to judge the quasi-static path by: M z'' + D z' + dU/dz + friction = torque, and at each capstan the elasto-plastic
/// friction of Dupont, Hayward, Armstrong and Altpeter (IEEE Trans. Automatic Control 47, 2002), which, unlike LuGre's, does not drift
/// under a load that varies below its limit. Shares nothing with StickSlip but the springs and the friction's level.
struct DynamicRig {
    double motor_inertia = 0.0002;        ///< at the capstan [kg m^2]: light, so that a minute is slow
    double joint_inertia = 0.0006;        ///< [kg m^2]
    double motor_viscous = 0.004;         ///< [Nms/rad]
    double hand_damping = 0.02;           ///< at the joint, all the time [Nms/rad]
    double bristle_stiffness = 4000.0;    ///< [Nm/rad]: a capstan deflects by tau_f/4000, up to 1e-4 rad, before it slides
    double bristle_damping = 0.5;         ///< [Nms/rad]: a third of critical with the motor's inertia
    double step = 2e-4;                   ///< of the integrator (semi-implicit Euler) [s]: 1/7 of the bristle's period
    double ramp_s = 6.0, hold_s = 2.0;    ///< of co-contraction and push
    double release_s = 10.0, rest_s = 2;  ///< slow release, then rest before q is read
};

struct DynamicReading {
    double q_low = 0.0, q_high = 0.0;  ///< [rad]
    double presliding = 0.0;           ///< greatest deflection of a capstan before it slides, tau_f/bristle_stiffness, at the joint [rad]
    [[nodiscard]] double width() const { return q_high - q_low; }
};

/// The push-and-release test of release_test in time: co-contract, push up, hold, release, rest, read; the same downwards.
[[nodiscard]] DynamicReading dynamic_release_test(const Joint& joint, double tau, double push_torque, const DynamicRig& rig = {});

}  // namespace fusee::actuator
