#pragma once
#include <string>

#include "fusee/identification/break_away.h"

namespace fusee::report {

/// The paper's figure 8: friction over load with its line, dots and error bars.
[[nodiscard]] std::string figure_8_chart(const identification::FrictionReport& friction);

}  // namespace fusee::report
