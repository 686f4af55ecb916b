#pragma once
#include "data/json.h"
#include "fusee/report/identification.h"

namespace fusee::report {

/// identification.json as an object.
[[nodiscard]] Json identification_object(const Identification& identification);

}  // namespace fusee::report
