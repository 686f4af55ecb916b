#pragma once
#include <string>

#include "fusee/core/text.h"
#include "fusee/core/units.h"

/// Figures as texts.
namespace fusee::report {

using core::coordinate;
using core::counted;
using core::deg_from_rad;
using core::escape;

/// `digits` significant digits, whole numbers in full; an en dash for NaN and infinities.
[[nodiscard]] std::string number(double value, int digits = 4);
/// An angle in degrees, without the unit.
[[nodiscard]] std::string deg(double rad, int digits = 4);
/// "0.85 Nm"
[[nodiscard]] std::string newton_metres(double torque, int digits = 3);
/// "0.12 to 0.5"; an en dash if an end is not known.
[[nodiscard]] std::string span(const core::Range& range, int digits = 3);
/// "9.1 \u2192 1.04"
[[nodiscard]] std::string change(double before, double after);
/// 0.62 is "62 %".
[[nodiscard]] std::string percent(double share);

}  // namespace fusee::report
