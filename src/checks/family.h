#pragma once
#include "fusee/checks/check.h"

namespace fusee::checks {

/// Is the rule about parts of the design's family? Rules of cable and groove do not apply to a roller's rim, and the other way round.
[[nodiscard]] bool suits(const Rule& rule, const Design& design);

/// The cable that rules measure from: on a roller's rim none, so that what they take for the groove's floor is the rim itself.
[[nodiscard]] Cable cable_on(const Design& design);

}  // namespace fusee::checks
