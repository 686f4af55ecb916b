#pragma once
#include "fusee/core/finding.h"
#include "settle.h"

namespace fusee::actuator {

/// Why a place where the joint settled is no resting place of its springs; empty if it is one.
[[nodiscard]] core::Findings refusals(const Joint& joint, const Eigen::Vector3d& torque, const Settled& settled);

/// "equilibrium.free" at z, if some motion meets no stiffness; without suggestion.
[[nodiscard]] core::Findings free_motion(const Joint& joint, const Eigen::Vector3d& z);

}  // namespace fusee::actuator
