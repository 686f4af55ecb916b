#include "fusee/actuator/equilibrium.h"

#include <fmt/format.h>

#include <Eigen/LU>

#include "fusee/core/error.h"
#include "refusal.h"
#include "settle.h"

// Equation numbers: docs/theory/equilibrium.md.
namespace fusee::actuator {

namespace {

void require_finite(const char* field, const Eigen::Vector3d& values) {
    if (!values.allFinite())
        throw core::InvalidInput(field, fmt::format("({:g}, {:g}, {:g})", values[0], values[1], values[2]), "finite numbers");
}

}  // namespace

core::Outcome<Equilibrium> find_equilibrium(const Joint& joint, const Eigen::Vector3d& torque, const Eigen::Vector3d& start) {
    require_finite("torque", torque);
    require_finite("start", start);
    const Settled settled = settle(joint, torque, start);
    if (core::Findings refusal = refusals(joint, torque, settled); !refusal.empty()) return refusal;
    return Equilibrium{settled.z, settled.residual, settled.steps};
}

core::Outcome<Eigen::Matrix3d> sensitivity(const Joint& joint, const Eigen::Vector3d& z) {
    if (core::Findings refusal = free_motion(joint, z); !refusal.empty()) return refusal;
    Eigen::Matrix3d inverse = free_stiffness(joint, z).inverse();
    for (int body = 0; body < 3; ++body)
        if (joint.frozen[static_cast<std::size_t>(body)]) inverse(body, body) = 0.0;
    return inverse;
}

Eigen::Matrix3d cable_space(const Eigen::Matrix3d& sensitivity, const Joint& joint) {
    const Eigen::Vector3d radii(joint.capstan_radius, joint.capstan_radius, joint.joint_radius);
    return radii.asDiagonal() * sensitivity * radii.asDiagonal();
}

Eigen::Matrix3d closed_sensitivity(double u1, double u2, double u3, double u4) {
    const double determinant = u1 * u2 * u3 + u1 * u2 * u4 + u1 * u3 * u4 + u2 * u3 * u4;
    const double side_1 = u1 + u2, side_2 = u3 + u4;
    Eigen::Matrix3d m;
    m << u2 * u3 + u2 * u4 + u3 * u4, -u2 * u3, -u2 * side_2,  //
        -u2 * u3, u1 * u2 + u1 * u3 + u2 * u3, u3 * side_1,    //
        -u2 * side_2, u3 * side_1, side_1 * side_2;
    return m / determinant;
}

}  // namespace fusee::actuator
