#pragma once
#include <string>

#include "fusee/gap/break_away.h"

namespace fusee::report {

/// The paper's figure 8: friction over load with its line, dots and error bars.
[[nodiscard]] std::string figure_8_chart(const gap::FrictionReport& friction);

}  // namespace fusee::report
