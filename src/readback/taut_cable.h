#pragma once
#include <vector>

#include "floor.h"

namespace fusee::readback {

/// The lever arm [mm] at every target row, with its sign (above 0 when the tension turns the cam by torque_sign): the body is turned to the
/// row's angle, and a taut cable is laid from the guide over the floor. Of all lines through the guide at half a cable from a floor point,
/// the one with the largest moment is tangent to the whole floor. NaN if no such line exists.
[[nodiscard]] std::vector<double> taut_arms(const Floor& floor, const exchange::PartFile& part);

}  // namespace fusee::readback
