#include "fusee/actuator/actuator.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "fusee/core/error.h"

namespace fusee::actuator {

core::Range Actuator::loads() const { return {least_torque / (1.0 + gear_friction), overdrive_torque / (1.0 - gear_friction)}; }

void validate(const Actuator& actuator) {
    if (!actuator.law) throw core::InvalidInput("law", "none", "a spring law");
    core::require_positive("capstan_radius", actuator.capstan_radius, "m");
    core::require_positive("joint_radius", actuator.joint_radius, "m");
    // At mu = 1 a gear holds any load: it cannot be driven back.
    if (!(actuator.gear_friction >= 0.0 && actuator.gear_friction < 1.0))
        throw core::InvalidInput("gear_friction", fmt::format("{:g}", actuator.gear_friction), "at least 0 and below 1");
    core::require_positive("least_torque", actuator.least_torque, "Nm");
    constexpr double kLargest = std::numeric_limits<double>::max();
    core::require_within("peak_torque", actuator.peak_torque, actuator.least_torque, kLargest, "Nm");
    core::require_within("overdrive_torque", actuator.overdrive_torque, actuator.peak_torque, kLargest, "Nm");
}

}  // namespace fusee::actuator
