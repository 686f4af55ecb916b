#pragma once
#include "fusee/effects/term.h"

/// The terms of each place.
namespace fusee::effects {

[[nodiscard]] std::vector<Term> gear_terms();
[[nodiscard]] std::vector<Term> spring_terms();
[[nodiscard]] std::vector<Term> joint_terms();

/// Experiments in which the joint or its motors move.
inline std::vector<Experiment> moving_experiments() {
    return {Experiment::kDeadBand, Experiment::kJointStiffness, Experiment::kCocontraction, Experiment::kLog};
}

/// Ripple counts to try, per rad: 1.25 apart, since a run over 2 rad tells half of that apart; beyond 20 a ripple is shorter than a usual
/// step of rows.
[[nodiscard]] inline std::vector<double> ripple_counts(double most) {
    std::vector<double> counts;
    for (double n = 1.0; n <= most; n += 1.25) counts.push_back(n);
    return counts;
}

}  // namespace fusee::effects
