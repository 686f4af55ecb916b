#pragma once
#include <array>

#include "fusee/gap_case/case.h"

namespace fusee::diagnosis {

inline constexpr double kUsualSteps = 1.2e5;   ///< of motion in one prediction of a full case, as case-template asks for it
inline constexpr double kMostSteps = 4e6;      ///< of a diagnosis, which is some thousand predictions: ten minutes on one core
inline constexpr double kMostPredicted = 2e9;  ///< of a prediction alone: a minute

/// Steps of motion (motion.h) that one prediction of each experiment takes, about.
[[nodiscard]] std::array<double, gap_case::kExperiments> motion_steps(const gap_case::Rows& rows, const gap_case::Protocol& protocol);

/// @throws core::InvalidInput naming the experiment that takes most of more than `most` steps, and why
void require_feasible(const gap_case::Rows& rows, const gap_case::Protocol& protocol, double most);

}  // namespace fusee::diagnosis
