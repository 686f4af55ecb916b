#pragma once
#include <Eigen/Core>

#include "fusee/actuator/joint.h"

namespace fusee::actuator {

/// Where a joint's energy less the torques' work is least, inside the springs' laws or not.
struct Settled {
    Eigen::Vector3d z = Eigen::Vector3d::Zero();
    double residual = 0.0;  ///< largest torque left over [Nm]
    double scale = 0.0;     ///< largest torque that acts on a body [Nm]: what `residual` is small against
    int steps = 0;
    bool ran_away = false;  ///< nothing stops the joint on its way; z is far out on it
    [[nodiscard]] bool at_rest() const { return !ran_away && residual <= 1e-9 * scale; }
};

/// Newton's method on the convex U(z) - torque.z; each step goes as far as the energy falls, so kinks of the stiffness (a preload stop, a
/// slack cable) cannot make it cycle. Frozen bodies stay at `start`.
[[nodiscard]] Settled settle(const Joint& joint, const Eigen::Vector3d& torque, const Eigen::Vector3d& start);

[[nodiscard]] inline double deflection(const JointSpring& spring, const Eigen::Vector3d& z) { return spring.offset + spring.jacobian_row.dot(z); }

/// d2U/dz2 with frozen bodies cut out; on their diagonal stands the largest stiffness, so that they disturb no eigenvalue.
[[nodiscard]] Eigen::Matrix3d free_stiffness(const Joint& joint, const Eigen::Vector3d& z);

}  // namespace fusee::actuator
