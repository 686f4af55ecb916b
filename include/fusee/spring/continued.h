#pragma once
#include "fusee/spring/potential.h"

namespace fusee::spring {

/// The same spring, extended beyond both ends by a share of its range, along the chord of its last piece of that length; below its lower
/// end no farther than to a torque of 0.
[[nodiscard]] PotentialPtr continued(PotentialPtr spring, double share);

}  // namespace fusee::spring
