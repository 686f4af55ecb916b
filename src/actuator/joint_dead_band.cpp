#include <cmath>

#include "fusee/actuator/dead_band.h"
#include "fusee/actuator/equilibrium.h"
#include "settle.h"

// Equation numbers: docs/theory/dead_band.md.
namespace fusee::actuator {

namespace {

/// Derivative of the stiffness matrix as the bodies move along `way`.
Eigen::Matrix3d stiffness_slope(const Joint& joint, const Eigen::Vector3d& z, const Eigen::Vector3d& way) {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const JointSpring& spring : joint.springs)
        sum += spring.potential->slope(deflection(spring, z)) * spring.jacobian_row.dot(way) * spring.jacobian_row *
               spring.jacobian_row.transpose();
    return sum;
}

/// eq. 10, 11: d(T tau_f)/dtau of one side while the bodies move along `way` for each Nm.
double condition(const Joint& joint, const JointDeadBand& band, const Eigen::Matrix3d& m, int side, double tau,
                 const Eigen::Vector3d& way) {
    const spring::FrictionLaw& friction = joint.gear_friction[static_cast<std::size_t>(side)];
    const Eigen::Matrix3d change = -m * stiffness_slope(joint, band.z, way) * m;
    const double own = m(kOutput, side), all = m(kOutput, kOutput), share = std::copysign(1.0 / joint.ratio(), own);
    const double transmission = share * own / all;
    const double slope = share * (change(kOutput, side) - own / all * change(kOutput, kOutput)) / all;
    return slope * friction.at_rest(tau) + transmission * friction.slope(tau);
}

JointDeadBand nowhere() {
    JointDeadBand band;
    band.z.setConstant(core::kNan);
    band.linear = band.exact_width = band.edges.low = band.edges.high = band.joint_stiffness = band.free_joint_stiffness = core::kNan;
    band.condition_5 = band.condition_6 = {core::kNan, core::kNan};
    band.covered = false;
    return band;
}

/// q where each capstan carries the end of its resting loads that moves the output to `side` (-1 or 1).
double edge(const Joint& joint, const std::array<core::Range, 2>& loads, const JointDeadBand& band, const Eigen::Matrix3d& m, int side) {
    Eigen::Vector3d torque = Eigen::Vector3d::Zero();
    for (int i = 0; i < 2; ++i) {
        const core::Range& range = loads[static_cast<std::size_t>(i)];
        torque[i] = m(kOutput, i) * side > 0.0 ? range.high : range.low;
    }
    const auto rest = find_equilibrium(joint, torque, band.z);
    return rest ? rest->z[kOutput] : core::kNan;
}

}  // namespace

JointDeadBand joint_dead_band(const Joint& joint, double tau_1, double tau_2) {
    const Eigen::Vector3d torque(tau_1, tau_2, 0.0);
    const auto rest = find_equilibrium(joint, torque);
    if (!rest) return nowhere();
    JointDeadBand band;
    band.z = rest->z;
    const Eigen::Matrix3d m = sensitivity(joint, band.z).value();
    std::array<core::Range, 2> loads;
    for (int i = 0; i < 2; ++i) {
        const auto at = static_cast<std::size_t>(i);
        loads[at] = joint.gear_friction[at].resting_loads(torque[i]);
        band.linear += std::abs(m(kOutput, i)) * 2.0 * joint.gear_friction[at].at_rest(torque[i]);
        band.condition_5[at] = condition(joint, band, m, i, torque[i], m.col(i));
        band.condition_6[at] = condition(joint, band, m, i, torque[i], m.col(kAgonist) + m.col(kAntagonist));
    }
    band.edges = {edge(joint, loads, band, m, -1), edge(joint, loads, band, m, 1)};
    band.exact_width = band.edges.width();
    band.covered = !std::isnan(band.exact_width);
    band.joint_stiffness = stiffness(joint, band.z)(kOutput, kOutput);
    band.free_joint_stiffness = 1.0 / m(kOutput, kOutput);
    return band;
}

}  // namespace fusee::actuator
