#include "fusee/actuator/equilibrium.h"

#include <fmt/format.h>

#include "fusee/pipeline/simulate.h"

namespace fusee::pipeline {

EquilibriumRow equilibrium_at(const actuator::Joint& joint, const Eigen::Vector3d& torque) {
    EquilibriumRow row{.torque = torque};
    const auto rest = actuator::find_equilibrium(joint, torque);
    if (!rest) {
        row.refusal = rest.refusal();
        for (core::Finding& finding : row.refusal) {
            if (!finding.where.empty()) finding.where += ", ";
            finding.where += fmt::format("at {}, {}, {} Nm", torque[0], torque[1], torque[2]);
        }
        return row;
    }
    row.z = rest->z;
    row.sensitivity = actuator::sensitivity(joint, row.z).value();  // springs hold every motion of a joint that rests
    row.cable_space = actuator::cable_space(row.sensitivity, joint);
    row.joint_stiffness = actuator::stiffness(joint, row.z)(actuator::kOutput, actuator::kOutput);
    row.free_joint_stiffness = 1.0 / row.sensitivity(actuator::kOutput, actuator::kOutput);
    if (torque[actuator::kOutput] == 0.0)
        row.dead_band = actuator::joint_dead_band(joint, torque[actuator::kAgonist], torque[actuator::kAntagonist]);
    return row;
}

}  // namespace fusee::pipeline
