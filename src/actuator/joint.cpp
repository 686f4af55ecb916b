#include "fusee/actuator/joint.h"

#include <limits>

#include "fusee/core/error.h"
#include "settle.h"

namespace fusee::actuator {

namespace {

/// Rounding of a place at the end of a law [rad].
constexpr double kDomainSlack = 1e-12;

}  // namespace

Joint antagonist(spring::PotentialPtr u1, spring::PotentialPtr u2, spring::PotentialPtr u3, spring::PotentialPtr u4,
                 const std::array<spring::FrictionLaw, 2>& gear_friction, double capstan_radius, double joint_radius) {
    core::require_positive("capstan_radius", capstan_radius, "m");
    core::require_positive("joint_radius", joint_radius, "m");
    const double g = joint_radius / capstan_radius;
    Joint joint;
    joint.gear_friction = gear_friction;
    joint.capstan_radius = capstan_radius;
    joint.joint_radius = joint_radius;
    const auto add = [&joint](const char* field, const char* name, spring::PotentialPtr potential, const Eigen::Vector3d& reach) {
        if (!potential) throw core::InvalidInput(field, "none", "a spring's potential");
        joint.springs.push_back({name, spring::behind_cable(std::move(potential)), reach, 0.0});
    };
    add("u1", "K_PE agonist", std::move(u1), {1.0, 0.0, 0.0});
    add("u2", "K_SE agonist", std::move(u2), {1.0, 0.0, g});
    add("u3", "K_SE antagonist", std::move(u3), {0.0, 1.0, -g});
    add("u4", "K_PE antagonist", std::move(u4), {0.0, 1.0, 0.0});
    return joint;
}

Joint joint_of(const Actuator& actuator, bool gears) {
    validate(actuator);
    const spring::FrictionLaw friction = gears ? actuator.gear_friction : spring::FrictionLaw::proportional(0.0);
    const spring::PotentialPtr series = spring::series_spring(actuator.law), parallel = spring::parallel_spring(actuator.law);
    return antagonist(parallel, series, series, parallel, {friction, friction}, actuator.capstan_radius, actuator.joint_radius);
}

double energy(const Joint& joint, const Eigen::Vector3d& z) {
    double sum = 0.0;
    for (const JointSpring& spring : joint.springs) sum += spring.potential->energy(deflection(spring, z));
    return sum;
}

Eigen::Vector3d spring_torques(const Joint& joint, const Eigen::Vector3d& z) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const JointSpring& spring : joint.springs) sum += spring.potential->force(deflection(spring, z)) * spring.jacobian_row;
    return sum;
}

Eigen::Matrix3d stiffness(const Joint& joint, const Eigen::Vector3d& z) {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const JointSpring& spring : joint.springs)
        sum += spring.potential->stiffness(deflection(spring, z)) * spring.jacobian_row * spring.jacobian_row.transpose();
    return sum;
}

std::vector<std::string> outside(const Joint& joint, const Eigen::Vector3d& z) {
    std::vector<std::string> names;
    for (const JointSpring& spring : joint.springs) {
        const core::Range domain = spring.potential->domain();
        const double x = deflection(spring, z);
        if (!(x >= domain.low - kDomainSlack && x <= domain.high + kDomainSlack)) names.push_back(spring.name);
    }
    return names;
}

core::Range Actuator::loads() const {
    return {gear_friction.resting_loads(least_torque).low, gear_friction.resting_loads(overdrive_torque).high};
}

void validate(const Actuator& actuator) {
    if (!actuator.law) throw core::InvalidInput("law", "none", "a spring law");
    core::require_positive("capstan_radius", actuator.capstan_radius, "m");
    core::require_positive("joint_radius", actuator.joint_radius, "m");
    core::require_positive("least_torque", actuator.least_torque, "Nm");
    constexpr double kLargest = std::numeric_limits<double>::max();
    core::require_within("peak_torque", actuator.peak_torque, actuator.least_torque, kLargest, "Nm");
    core::require_within("overdrive_torque", actuator.overdrive_torque, actuator.peak_torque, kLargest, "Nm");
}

}  // namespace fusee::actuator
