#pragma once
#include "fusee/spring/law.h"
#include "fusee/spring/potential.h"

namespace fusee::spring {

/// The two springs of a law, each over the capstan's angle; their domain is the law's angles. They share the law.
[[nodiscard]] PotentialPtr series_spring(SpringLawPtr law);
[[nodiscard]] PotentialPtr parallel_spring(SpringLawPtr law);

/// A spring behind a cable, defined at every deflection: inside `domain()` the spring itself; below it the preload stop, where the force
/// falls linearly to 0 within `stop_travel` and stays 0 (a cable cannot push); above it the force continues with the stiffness at the law's
/// end. C1 energy, convex if the spring is. `domain()` stays that of the spring, so that a caller can see which applies.
/// @throws InvalidInput unless stop_travel > 0, and if the spring would push at its lower end
[[nodiscard]] PotentialPtr behind_cable(PotentialPtr spring, double stop_travel = 1e-4);

}  // namespace fusee::spring
