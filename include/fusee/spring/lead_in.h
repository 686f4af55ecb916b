#pragma once
#include "fusee/core/finding.h"
#include "fusee/spring/law.h"

namespace fusee::spring {

/// A low-load law below a law's start: over `travel` [rad] of capstan both stiffnesses go on with the slope they have at the start, which
/// fades linearly to zero at the lower end: S(x) = S0 + S0' (x + x^2/(2 travel)), x in [-travel, 0]. U''' is continuous, so the arms are
/// C2. Below it the springs rest on their preload stops. travel = 0 returns the law as it is. Refusal: "law.lead_in" when a stiffness or
/// torque would not stay above zero, with the largest travel that does.
/// @throws InvalidInput if travel is negative or not finite
[[nodiscard]] core::Outcome<SpringLawPtr> with_lead_in(SpringLawPtr law, double travel);

}  // namespace fusee::spring
