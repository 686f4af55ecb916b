#pragma once
#include "fusee/pipeline/evaluate.h"
#include "fusee/search/one_spring.h"

/// What a part of one spring is like, and what a search of the smallest one pays for it.
namespace fusee::search::one_spring {

/// Those of a severity.
[[nodiscard]] core::Findings broken_in(const core::Findings& all, core::Severity severity);

inline constexpr double kRefused = 1e3;  ///< least cost of a draft that breaks a rule

/// A measure of that room, below 1, or at least `kRefused`: how far the draft is from being a part.
[[nodiscard]] double cost_of(const pipeline::Evaluation& seen, const profile::Profile& draft);

/// A draft as a part of a front, both parts of two cables one on the other. @pre it passed @param torque largest of the law, without sign
/// [Nm]
[[nodiscard]] Family::Candidate candidate_of(const pipeline::Evaluation& seen, const profile::Profile& draft, double torque);

/// The same of a profile whose spring is known. @pre solids
[[nodiscard]] Figures figures_of(const pipeline::Evaluation& seen, const profile::Profile& profile, double torque);

}  // namespace fusee::search::one_spring
