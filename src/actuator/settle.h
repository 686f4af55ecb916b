#pragma once
#include <Eigen/Core>

#include "fusee/actuator/joint.h"

namespace fusee::actuator {

/// Place of the least energy minus work of the torques, inside the springs' laws or not.
struct Settled {
    Eigen::Vector3d z = Eigen::Vector3d::Zero();
    double residual = 0.0;  ///< largest remaining torque [Nm]
    double scale = 0.0;     ///< largest torque on a body [Nm]: reference of `residual`
    int steps = 0;
    bool ran_away = false;  ///< no spring stops the joint; z is far away
    [[nodiscard]] bool at_rest() const { return !ran_away && residual <= 1e-9 * scale; }
};

/// Newton's method on the convex U(z) - torque.z; each step goes to the least energy on its line, so that kinks of the stiffness (a preload
/// stop, a slack cable) cannot make it cycle. Frozen bodies stay at `start`.
[[nodiscard]] Settled settle(const Joint& joint, const Eigen::Vector3d& torque, const Eigen::Vector3d& start);

[[nodiscard]] inline double deflection(const JointSpring& spring, const Eigen::Vector3d& z) {
    return spring.offset + spring.jacobian_row.dot(z);
}

/// d2U/dz2 with frozen bodies cut out; their diagonal has the largest stiffness, so that they affect no eigenvalue.
[[nodiscard]] Eigen::Matrix3d free_stiffness(const Joint& joint, const Eigen::Vector3d& z);

}  // namespace fusee::actuator
