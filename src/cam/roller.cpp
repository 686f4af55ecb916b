#include <cmath>

#include "fusee/cam/cam.h"
#include "fusee/core/units.h"
#include "rolled.h"

namespace fusee::cam {

const char* to_string(Family family) { return family == Family::kCable ? "cable" : "roller"; }

double follower_start(const Roller& roller) {
    const double centre = roller.base_radius + roller.radius;
    return std::sqrt(centre * centre - roller.offset * roller.offset);
}

double pressure_angle(const ArmPoint& arm, const Roller& roller) {
    const Follower<double> f(arm, roller);
    return std::atan2(f.across, f.s);
}

double pitch_radius(const ArmPoint& arm, const Roller& roller) { return rolled_pitch_radius(Follower<double>(arm, roller), arm); }

double contact_pressure(const ArmPoint& arm, const Roller& roller) {
    const double normal = arm.tension / std::cos(pressure_angle(arm, roller)), rho = pitch_radius(arm, roller) - roller.radius;
    return std::sqrt(normal * roller.contact_modulus / (core::kPi * roller.width) * (1.0 / roller.radius + 1.0 / rho));
}

}  // namespace fusee::cam
