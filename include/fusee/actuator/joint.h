#pragma once
#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "fusee/spring/friction.h"
#include "fusee/spring/law.h"
#include "fusee/spring/potential.h"

namespace fusee::actuator {

/// The symmetric antagonistic joint: two capstans, each with one gear, one K_SE and one K_PE. Immutable.
struct Actuator {
    spring::SpringLawPtr law;                                                     ///< of both sides
    double capstan_radius = 0.0;                                                  ///< r_c [m]
    double joint_radius = 0.0;                                                    ///< r_j [m]
    spring::FrictionLaw gear_friction = spring::FrictionLaw::proportional(0.0);   ///< of both gears
    double least_torque = 0.0;                                                    ///< least co-contraction used [Nm]
    double peak_torque = 0.0;                                                     ///< continuous [Nm]
    double overdrive_torque = 0.0;                                                ///< for a short time [Nm]; >= peak_torque
    [[nodiscard]] double ratio() const { return joint_radius / capstan_radius; }  ///< g = r_j / r_c
    /// Loads that the springs must carry, stiction included: from the least resting load at least_torque to the greatest at
    /// overdrive_torque [Nm]; least/(1+mu) to overdrive/(1-mu) for friction in proportion to the load.
    [[nodiscard]] core::Range loads() const;
};

/// @throws InvalidInput naming the member
void validate(const Actuator& actuator);

/// Indices in every vector and matrix of a joint: capstan 1 (agonist), capstan 2 (antagonist), output.
/// Angles z = (theta_1, theta_2, q) [rad], torques (tau_1, tau_2, tau_q) [Nm]. Capstan angles and torques are positive when they wind their
/// cable in (the paper counts the agonist's negative); q and tau_q are positive when the agonist's cable is stretched.
enum Body : int { kAgonist = 0, kAntagonist = 1, kOutput = 2 };

/// One spring of a joint, deflected by x = offset + jacobian_row . z.
struct JointSpring {
    std::string name;  ///< "K_PE agonist"
    spring::PotentialPtr potential;
    Eigen::Vector3d jacobian_row = Eigen::Vector3d::Zero();  ///< dx/dz
    double offset = 0.0;                                     ///< [rad]
};

/// Friction at the output's bearing: |torque| <= constant + tension_share * (sum of the torques of the springs at the output).
struct OutputFriction {
    double constant = 0.0;       ///< [Nm]
    double tension_share = 0.0;  ///< c, no unit
};

/// Any joint of two motors and an output with springs between them: U(z) = sum U_i(x_i). Immutable.
struct Joint {
    std::vector<JointSpring> springs;
    std::array<spring::FrictionLaw, 2> gear_friction{spring::FrictionLaw::proportional(0.0), spring::FrictionLaw::proportional(0.0)};
    double capstan_radius = 0.0;  ///< r_c [m]
    double joint_radius = 0.0;    ///< r_j [m]
    OutputFriction output_friction = {};
    std::array<bool, 3> frozen{};                                                 ///< fixed bodies (a series elastic joint has one motor)
    [[nodiscard]] double ratio() const { return joint_radius / capstan_radius; }  ///< g
};

/// The paper's antagonist (figure 3): U_1 (K_PE) and U_2 (K_SE) of the agonist, U_3 (K_SE) and U_4 (K_PE) of the antagonist, in that order:
/// U = U_1(theta_1) + U_2(theta_1 + g q) + U_3(theta_2 - g q) + U_4(theta_2). The potentials are placed behind cables.
/// @throws InvalidInput naming the member
[[nodiscard]] Joint antagonist(spring::PotentialPtr u1, spring::PotentialPtr u2, spring::PotentialPtr u3, spring::PotentialPtr u4,
                               const std::array<spring::FrictionLaw, 2>& gear_friction, double capstan_radius, double joint_radius);
/// The symmetric actuator as such a joint; its gears without friction if `gears` is false (the paper's frame subsystem: masses for motors).
[[nodiscard]] Joint joint_of(const Actuator& actuator, bool gears = true);

[[nodiscard]] double energy(const Joint& joint, const Eigen::Vector3d& z);  ///< U [J]
/// dU/dz [Nm]: the torques that motors and load must exert.
[[nodiscard]] Eigen::Vector3d spring_torques(const Joint& joint, const Eigen::Vector3d& z);
[[nodiscard]] Eigen::Matrix3d stiffness(const Joint& joint, const Eigen::Vector3d& z);  ///< d2U/dz2 [Nm/rad], symmetric
/// The springs outside the domain of their law at z: slack, on their stop, or beyond their end.
[[nodiscard]] std::vector<std::string> outside(const Joint& joint, const Eigen::Vector3d& z);

}  // namespace fusee::actuator
