#pragma once
#include "fusee/spring/potential.h"

namespace fusee::spring {

/// The same spring tabulated once, for many evaluations: its force as piecewise Chebyshev series with their exact integral and
/// derivatives. Relative accuracy of the force 1e-12, of stiffness and slope 1e-9 and 1e-6; near an asymptote, where the load is
/// ill-conditioned in the angle, up to 1000 times less. A spring with kinks, for which no series converges, is returned unchanged.
[[nodiscard]] PotentialPtr resampled(PotentialPtr spring);

}  // namespace fusee::spring
