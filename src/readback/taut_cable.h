#pragma once
#include <vector>

#include "floor.h"

namespace fusee::readback {

/// The lever arm [mm] at every target row, with its sign (above 0 when the tension turns the cam by torque_sign): the body is turned to the
/// row's angle and a taut cable laid from the guide over the floor. Of all lines that touch a floor point with half a cable between and
/// pass the guide, the one of largest moment is tangent to the whole floor. NaN where no such line exists.
[[nodiscard]] std::vector<double> taut_arms(const Floor& floor, const exchange::PartFile& part);

}  // namespace fusee::readback
