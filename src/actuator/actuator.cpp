#include <limits>

#include "fusee/actuator/joint.h"
#include "fusee/core/error.h"

namespace fusee::actuator {

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
