#pragma once
#include "fusee/core/finding.h"
#include "settle.h"

namespace fusee::actuator {

/// Findings if the place where the joint settled is not a resting place of its springs.
[[nodiscard]] core::Findings refusals(const Joint& joint, const Eigen::Vector3d& torque, const Settled& settled);

/// "equilibrium.free" if a motion at z has no stiffness; without suggestion.
[[nodiscard]] core::Findings free_motion(const Joint& joint, const Eigen::Vector3d& z);

}  // namespace fusee::actuator
