#pragma once
#include <cmath>

#include "fusee/core/units.h"

namespace fusee::core {

inline constexpr double kTurn = 2.0 * kPi;  ///< [rad]

/// The same direction within [low, low + kTurn).
[[nodiscard]] inline double within_turn(double angle, double low) { return angle - kTurn * std::floor((angle - low) / kTurn); }

}  // namespace fusee::core
