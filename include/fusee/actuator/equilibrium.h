#pragma once
#include <Eigen/Core>
#include <optional>

#include "fusee/actuator/joint.h"
#include "fusee/core/finding.h"

namespace fusee::actuator {

struct Equilibrium {
    Eigen::Vector3d z = Eigen::Vector3d::Zero();  ///< (theta_1, theta_2, q) [rad]
    double residual = 0.0;                        ///< largest remaining torque [Nm]
    int steps = 0;
};

/// Resting place of the frictionless joint under `torque`: paper (1), dU/dz = torque, any potentials, any three torques. U is convex where
/// every stiffness is >= 0, so the resting place is unique (footnote 2) and damped Newton finds it from any start.
/// Refusals: "equilibrium.free" (no spring holds a motion: a = b = 0 of figure 1, or a slack cable), "equilibrium.outside" (it rests
/// outside a spring's law; the nearest torques that keep it inside are suggested), "equilibrium.convexity" (a spring softens to below 0, or
/// its torque jumps).
/// @throws InvalidInput if a torque or the start is not finite
[[nodiscard]] core::Outcome<Equilibrium> find_equilibrium(const Joint& joint, const Eigen::Vector3d& torque,
                                                          const Eigen::Vector3d& start = Eigen::Vector3d::Zero());
/// The same without reasons, which cost as much as the place. None: find_equilibrium refuses. @throws as find_equilibrium
[[nodiscard]] std::optional<Equilibrium> equilibrium(const Joint& joint, const Eigen::Vector3d& torque,
                                                     const Eigen::Vector3d& start = Eigen::Vector3d::Zero());

/// The whole matrix (2), d(theta_1, theta_2, q)/d(tau_1, tau_2, tau_q) [rad/Nm]: the inverse of the stiffness (implicit function theorem).
/// Rows and columns of frozen bodies are 0. Refusal: "equilibrium.free".
[[nodiscard]] core::Outcome<Eigen::Matrix3d> sensitivity(const Joint& joint, const Eigen::Vector3d& z);

/// (2) with the paper's hats: arcs r_c theta, r_j q over forces tau/r_c, tau_q/r_j [m/N].
[[nodiscard]] Eigen::Matrix3d cable_space(const Eigen::Matrix3d& sensitivity, const Joint& joint);

}  // namespace fusee::actuator
