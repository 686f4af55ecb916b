#pragma once
#include "fusee/spring/potential.h"

namespace fusee::spring {

/// A spring with a linear compliance c [rad/Nm] in series, as behind a cable that stretches:
///     X = x + c (F(x) - F_low),   dF/dX = S/(1 + c S),   d2F/dX2 = S'/(1 + c S)^3                    (docs/theory/springs.md, eq. 28)
/// The deflection counts from the spring's lower end, where the cable is already taut and carries F_low. c = 0 returns the spring.
/// c below 0 removes a compliance that the spring already contains. @throws InvalidInput unless 1 + c S > 0 at both ends of the domain
[[nodiscard]] PotentialPtr with_compliance(PotentialPtr spring, double compliance);

}  // namespace fusee::spring
