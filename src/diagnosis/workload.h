#pragma once
#include <array>

#include "fusee/gap_case/case.h"

namespace fusee::diagnosis {

inline constexpr double kUsualSteps = 1.2e5;   ///< motion steps of one prediction of a full case of case-template
inline constexpr double kMostSteps = 4e6;      ///< limit of a diagnosis with some thousand predictions: ten minutes on one core
inline constexpr double kMostPredicted = 2e9;  ///< limit of one prediction: a minute

/// Steps of motion (motion.h) that one prediction of each experiment takes, about.
[[nodiscard]] std::array<double, gap_case::kExperiments> motion_steps(const gap_case::NominalRig& rig, const gap_case::Rows& rows,
                                                                         const gap_case::Protocol& protocol);

/// @throws core::InvalidInput naming the longest experiment if the case needs more than `most` steps
void require_feasible(const gap_case::NominalRig& rig, const gap_case::Rows& rows, const gap_case::Protocol& protocol, double most);

}  // namespace fusee::diagnosis
