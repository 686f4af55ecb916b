#pragma once
#include <span>
#include <vector>

#include "fusee/diagnosis/diagnosis.h"
#include "fusee/inference/fit.h"

namespace fusee::diagnosis {

/// Instruction, expected information [bit] and cost as one sentence.
[[nodiscard]] std::string sentence_of(const inference::Measurement& measurement, double bits);

/// Expected information of each measurement of a menu on which of `rivals` is true [bit]. A rival's outcomes are Gaussian: its
/// prediction at its fit; what its parameters may still be, by its covariance; and the `uncertainty` of such rows.
/// @pre as many probabilities as rivals, at least two of each, summing to 1
[[nodiscard]] std::vector<double> expected_bits(const inference::Problem& problem, const inference::Menu& menu,
                                                const std::vector<const inference::Fit*>& rivals, std::span<const double> probabilities,
                                                unsigned jobs);

/// Most information that a measurement gives on which of two is true, the first fit or each of the others, as likely as not [bit]. Empty if
/// the model has no menu.
[[nodiscard]] std::vector<double> most_bits_against_first(const inference::Problem& problem, const std::vector<const inference::Fit*>& fits,
                                                          unsigned jobs);

/// Further measurements that distinguish `rivals`, the best of each experiment (docs/theory/isolability.md). First the cheapest that is
/// expected to decide, 90 % of the entropy, if there is one; then by bits per minute. If none gives a tenth of the entropy: the one
/// with most information, with a text that says so and how large the effect would have to be. Empty if there is nothing to decide: fewer
/// than two rivals, or all the probability on one.
/// @param probabilities one a rival, >= 0, of any sum. Each rival costs some 30 predictions of 40 s of motion.
[[nodiscard]] std::vector<NextExperiment> next_experiments(const inference::Problem& problem,
                                                           const std::vector<const inference::Fit*>& rivals,
                                                           std::span<const double> probabilities, unsigned jobs);

/// Further measurements that would show `unseen` causes: whether a usual size of one is there, a priori as likely as not. Information is
/// the mean over the causes, what is known of the build parameters is that of the `null` fit. The best of each experiment, in the order of
/// next_experiments. @pre at least one cause
[[nodiscard]] std::vector<NextExperiment> showing_experiments(const inference::Problem& problem, const inference::Fit& null,
                                                              const std::vector<inference::Cause>& unseen, unsigned jobs);

}  // namespace fusee::diagnosis
