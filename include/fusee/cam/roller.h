#pragma once
#include "fusee/cam/arm.h"

namespace fusee::cam {

/// The follower of a cam.
enum class Family {
    kCable,   ///< a cable in its groove
    kRoller,  ///< the roller of a follower that slides along a line and compresses the spring; K_PE only
};
[[nodiscard]] const char* to_string(Family family);  ///< "cable", "roller"

/// A follower that slides along a line beside the cam's axis, with a roller on the cam's rim (docs/theory/roller.md, eq. 1 to 4).
struct Roller {
    double radius = 6e-3;                   ///< R_r [m]
    double base_radius = 20e-3;             ///< R_b: axis to roller centre at the law's lowest load, less R_r [m]
    double offset = 0.0;                    ///< e: distance of the line from the axis; e > 0 reduces the pressure angle of the rise [m]
    double direction = 1.5707963267948966;  ///< in the world: along the line, away from the axis, as the spring is compressed [rad]
    double width = 5e-3;                    ///< of the roller's cylinder [m]
    double contact_modulus = 0.0;           ///< E*: 1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2 [Pa]; 0 = pressure not checked
    double max_pressure = 0.0;              ///< allowed contact pressure of cam and roller, Hertz [Pa]; 0 = not checked
};

/// s_0: the roller's centre along the line at the law's lowest load, from the foot of the axis' perpendicular [m].
[[nodiscard]] double follower_start(const Roller& roller);
/// phi, between the contact's normal and the follower's line: tan phi = (r - e)/(s_0 + y) [rad].
[[nodiscard]] double pressure_angle(const ArmPoint& arm, const Roller& roller);
/// Radius of curvature of the roller centre's curve on the cam [m]; below 0: the curve is concave there, and no convex rim exists.
[[nodiscard]] double pitch_radius(const ArmPoint& arm, const Roller& roller);
/// Largest pressure between cam and roller, two cylinders along one line (Hertz): sqrt(N E*/(pi width) (1/R_r + 1/rho)), N = F/cos phi
/// [Pa].
[[nodiscard]] double contact_pressure(const ArmPoint& arm, const Roller& roller);

}  // namespace fusee::cam
