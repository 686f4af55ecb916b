#pragma once
#include "fusee/spring/potential.h"

namespace fusee::spring {

/// The same spring tabulated once, for those who ask it many times: its force as piecewise Chebyshev series with their exact integral and
/// derivatives. Relative accuracy of the force 1e-12, of stiffness and slope 1e-9 and 1e-6; near an asymptote, where the angle itself
/// hardly knows the load, up to 1000 times less. A spring with kinks, which no series follows, is returned as it is.
[[nodiscard]] PotentialPtr resampled(PotentialPtr spring);

}  // namespace fusee::spring
