#pragma once
#include <array>

#include "fusee/pipeline/design.h"

namespace fusee::pipeline {

/// The profiles of both cables of a single spring, each alone: first of the one that pulls forth; the angle of the other counts down. Both
/// stand on one shaft whose key is at angle 0 of both bodies: the world of the way back is turned by the law's travel (docs/theory/cams.md,
/// eq. 23).
/// @param travel of the law [rad]
[[nodiscard]] std::array<profile::Profile, 2> each_way(const profile::Profile& both, double travel);

}  // namespace fusee::pipeline
