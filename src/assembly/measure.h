#pragma once
#include <string>

#include "fusee/assembly/motion.h"
#include "fusee/assembly/rule.h"

namespace fusee::assembly {

using checks::Allowed, checks::required, checks::review, checks::kAtLeast, checks::kAtMost;

/// "capstans at 35 and 0 deg, cables paid out by 12.1 and 0 mm"
[[nodiscard]] std::string place_text(const Pose& pose);

}  // namespace fusee::assembly
