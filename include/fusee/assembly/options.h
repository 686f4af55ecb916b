#pragma once

namespace fusee::assembly {

/// Options of the profile's table [assembly].
struct AssemblyOptions {
    double motor_distance = 0.0;                  ///< joint axis to the motors' axes along y [m]; 0: the least that the bodies need
    double k_pe_direction = -1.5707963267948966;  ///< of K_PE's cable from the agonist's motor axis, in the assembly's frame [rad]
    double joint_range = 0.0;                     ///< of the joint between its stops [rad]; 0: what springs and pulley allow
    double gap = 1e-3;                            ///< between bodies that are placed by the layout [m]
    double wall = 4e-3;                           ///< of plates and of the carriage [m]
    bool frame = true;                            ///< a plate with brackets that hold all that is fixed
};

}  // namespace fusee::assembly
