#pragma once
#include "data/json.h"
#include "fusee/design/budget.h"

namespace fusee::report {

/// Lengths of bands and sigmas in percent and degrees, as their names say.
[[nodiscard]] Json budget_to_json(const design::budget::Budget& budget);

}  // namespace fusee::report
