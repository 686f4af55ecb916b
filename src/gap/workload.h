#pragma once
#include <array>

#include "fusee/gap/case.h"

namespace fusee::gap {

inline constexpr double kUsualSteps = 1.2e5;  ///< of motion in one prediction of a full case, as case-template asks for it
inline constexpr double kMostSteps = 4e6;     ///< a diagnosis is some thousand predictions: an hour on one core

/// Steps of motion (motion.h) that one prediction of each experiment takes, about.
[[nodiscard]] std::array<double, kExperiments> motion_steps(const Rows& rows, const Protocol& protocol);

/// @throws core::InvalidInput naming the experiment that takes most of more than kMostSteps, and why
void require_feasible(const Case& bench);

}  // namespace fusee::gap
