#pragma once
#include <vector>

#include "floor.h"

namespace fusee::readback {

/// The lever arm [mm] at every target row that gives the found torque: the body is turned to the row's angle and the roller pushed against
/// the rim along its line or about its pivot. The arm is the slope of the spring's travel over the angle, times the spring's force there
/// over the requested force (docs/part-file.md). The slope is a mean over 0.2 rad, which averages the facets of a mesh. NaN if the roller
/// touches no point.
/// @pre part.guide.has_roller()
[[nodiscard]] std::vector<double> pushed_arms(const Floor& rim, const exchange::PartFile& part);

}  // namespace fusee::readback
