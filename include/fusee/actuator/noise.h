#pragma once
#include <Eigen/Core>
#include <vector>

#include "fusee/actuator/joint.h"
#include "fusee/core/finding.h"

namespace fusee::actuator {

/// M z'' + D z' + K z = w, w white force noise of two-sided spectral density N (E[w w^T] = N delta): the stationary covariance of (z, z').
/// Solves the Lyapunov equation A X + X A^T + Q = 0 as a linear system of 4 n^2 unknowns for n bodies: for a few bodies. Refusal:
/// "noise.unbounded" if a motion has no spring to ground or no damping (a = b = 0 of figure 1: noise drives it arbitrarily far), naming it.
/// @throws InvalidInput naming the matrix unless M is symmetric positive definite and D, K, N are symmetric positive semidefinite
[[nodiscard]] core::Outcome<Eigen::MatrixXd> stationary_covariance(const Eigen::MatrixXd& mass, const Eigen::MatrixXd& damping,
                                                                   const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& density);

/// Figure 1: motor and joint, springs a (motor to ground), b (joint to ground) and c (between them), dampers d (motor) and e (joint).
struct NoisePath {
    double a = 0.0, b = 0.0, c = 0.0;             ///< [Nm/rad], >= 0
    double d = 0.0, e = 0.0;                      ///< [Nms/rad], >= 0
    double motor_inertia = 0.0;                   ///< [kg m^2]
    double joint_inertia = 0.0;                   ///< [kg m^2]
    double motor_noise = 0.0, joint_noise = 0.0;  ///< spectral density of the torque noise [(Nm)^2 s]
};
struct NoiseResponse {
    double motor_variance = 0.0;  ///< [rad^2]
    double joint_variance = 0.0;  ///< [rad^2]
    Eigen::Matrix4d covariance;   ///< of (theta, q, theta', q')
};
/// Refusal: "noise.unbounded". @throws InvalidInput naming the member
[[nodiscard]] core::Outcome<NoiseResponse> passive_noise(const NoisePath& path);
/// d(joint_variance)/dc [rad^3/Nm]: below 0 where a stiffer c rejects more noise (not everywhere, docs/theory/noise.md).
[[nodiscard]] core::Outcome<double> joint_variance_slope(const NoisePath& path);

/// Inertia, damping and noise of a whole joint.
struct NoiseOptions {
    double motor_inertia = 0.0, joint_inertia = 0.0;  ///< at the capstan, at the joint [kg m^2], > 0
    double motor_viscous = 0.0, joint_viscous = 0.0;  ///< [Nms/rad], >= 0
    double motor_noise = 0.0, joint_noise = 0.0;      ///< [(Nm)^2 s]
};
/// The joint linearised at equal co-contraction tau (gears moving: no stiction): standard deviations of theta_1, theta_2, q [rad]; 0 for a
/// frozen body. Refusals: "noise.unbounded" and those of find_equilibrium. @throws InvalidInput naming the option
[[nodiscard]] core::Outcome<Eigen::Vector3d> joint_noise(const Joint& joint, double tau, const NoiseOptions& options);

}  // namespace fusee::actuator
