#pragma once
#include "fusee/plant/rig.h"

namespace fusee::plant {

/// Operating range of a rig in the experiments: reference of effect and push sizes.
struct RigRange {
    const Nominal* nominal = nullptr;
    double scale = 1.0;      ///< of every torque set point: top torque/1.5 Nm
    double travel = 0.0;     ///< capstan angle at the top torque without friction [rad]
    double series = 0.0;     ///< F_SE there [Nm]
    double spool = 0.0;      ///< spool angle there [rad]
    double stroke = 0.0;     ///< compression there [m]
    double se_arm = 0.0;     ///< of K_SE's cam half way [m]
    double pe_arm = 0.0;     ///< of K_PE's cam at the top torque [m]
    double most_push = 0.0;  ///< at the joint, that K_SE bears inside its table [Nm]
    double reach = 0.0;      ///< joint angle of a push of half of it, the other cable slack and both capstans unwound [rad]
};
[[nodiscard]] RigRange range_of(const Nominal& nominal);

}  // namespace fusee::plant
