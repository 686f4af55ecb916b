#pragma once
#include <vector>

#include "floor.h"

namespace fusee::readback {

/// The lever arm [mm] at every target row that gives the torque found: the body is turned to the row's angle and the roller pushed against
/// the rim along its line; slope of the place found over the angle, times the spring's force there over the force asked for
/// (docs/part-file.md). The slope's deviation is taken over 0.2 rad, in which a mesh has its facets. NaN where the roller meets no point.
/// @pre part.guide.kind is "roller"
[[nodiscard]] std::vector<double> pushed_arms(const Floor& rim, const exchange::PartFile& part);

}  // namespace fusee::readback
