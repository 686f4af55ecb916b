#pragma once
#include <Eigen/Core>

#include "fusee/actuator/joint.h"

namespace fusee::actuator {

/// Spring torques dU/dz between which a body stays: it turns up while its torque is `low`, down while it is `high`. [Nm], low <= high.
struct PlayLimits {
    Eigen::Vector3d low, high;
};

struct RestingPlace {
    Eigen::Vector3d z;  ///< [rad]
    bool held = true;   ///< false: no spring stops the motion; z is where the search ended
};

/// Resting place of a joint that starts at `from`: the least of U(z) + sum_i max(-low_i d_i, -high_i d_i), d = z - from
/// (docs/theory/stick_slip.md, eq. 3). Bodies that stay keep exactly their place in `from`.
/// @param guess start of the search: the nearer, the faster
[[nodiscard]] RestingPlace find_resting_place(const Joint& joint, const PlayLimits& limits, const Eigen::Vector3d& from,
                                              const Eigen::Vector3d& guess);

}  // namespace fusee::actuator
