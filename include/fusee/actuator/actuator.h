#pragma once
#include "fusee/friction/law.h"
#include "fusee/spring/law.h"

namespace fusee::actuator {

/// The symmetric antagonistic joint: two capstans, each with one gear, one K_SE and one K_PE. Immutable.
struct Actuator {
    spring::SpringLawPtr law;                                                     ///< of both sides
    double capstan_radius = 0.0;                                                  ///< r_c [m]
    double joint_radius = 0.0;                                                    ///< r_j [m]
    friction::Law gear_friction = friction::Law::proportional(0.0);               ///< of both gears
    double least_torque = 0.0;                                                    ///< least co-contraction used [Nm]
    double peak_torque = 0.0;                                                     ///< continuous [Nm]
    double overdrive_torque = 0.0;                                                ///< for a short time [Nm]; >= peak_torque
    [[nodiscard]] double ratio() const { return joint_radius / capstan_radius; }  ///< g = r_j / r_c
    /// Loads that the springs must carry, stiction included: from the least resting load at least_torque to the greatest at
    /// overdrive_torque [Nm]; least/(1+mu) to overdrive/(1-mu) for friction in proportion to the load.
    [[nodiscard]] core::Range loads() const;
};

/// @throws InvalidInput naming the member
void validate(const Actuator& actuator);

}  // namespace fusee::actuator
