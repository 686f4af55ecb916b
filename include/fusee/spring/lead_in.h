#pragma once
#include "fusee/core/finding.h"
#include "fusee/spring/law.h"

namespace fusee::spring {

/// Extends a law below its start: over `travel` [rad] of capstan both stiffnesses continue with their slope at the start, which falls
/// linearly to zero at the lower end: S(x) = S0 + S0' (x + x^2/(2 travel)), x in [-travel, 0]. U''' is continuous, so the arms are
/// C2. Below it the springs rest on their preload stops. travel = 0 returns the law. Refusal: "law.lead_in" if a stiffness or torque would
/// not stay above zero, with the largest travel for which both do.
/// @throws InvalidInput if travel is negative or not finite
[[nodiscard]] core::Outcome<SpringLawPtr> with_lead_in(SpringLawPtr law, double travel);

}  // namespace fusee::spring
