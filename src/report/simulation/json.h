#pragma once
#include "data/json.h"
#include "fusee/report/simulation.h"

namespace fusee::report {

/// simulation.json without the old spelling of renamed fields.
[[nodiscard]] Json simulation_object(const Simulation& simulation);

}  // namespace fusee::report
