#pragma once
#include <string>

#include "fusee/report/simulation.h"

namespace fusee::report {

/// The equilibria that were asked for, for a terminal.
[[nodiscard]] std::string equilibria_text(const Simulation& simulation);

}  // namespace fusee::report
