#pragma once
#include "fusee/checks/check.h"

namespace fusee::checks {

/// Inner radius of the bend between coil and axial leg [m]: as stated, else the wire's diameter.
double leg_bend_radius(const spring::BaseSpring& spring);
/// Force of the leg on the middle of its slot at the largest torque [N]. @pre the part has a slot
double leg_force(const Design& design);

}  // namespace fusee::checks
