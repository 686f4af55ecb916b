#pragma once

namespace fusee::budget {

/// Options of the profile's table [budget]: limits to both sides that the process does not state, two standard deviations each.
struct Options {
    double runout = 0.0;                       ///< of a cam's axis on its shaft [m]; 0: half of the bore's clearance
    double guide = 0.3e-3;                     ///< of a hole or idler, across its cable [m]
    double direction = 8.7266462599716477e-3;  ///< of a parallel exit [rad]
    double rate = 0.1;                         ///< of a base spring whose rate is nominal
    double measured_rate = 0.02;               ///< of one whose rate was measured
    double preload = 0.02;                     ///< of the base spring's state at the law's lowest load
    double cable = 0.05;                       ///< of the cable's diameter
    double zero = 8.7266462599716477e-3;       ///< of the capstan's angle against the cams [rad]
    double friction = 0.2;                     ///< of a gear
};

}  // namespace fusee::budget
