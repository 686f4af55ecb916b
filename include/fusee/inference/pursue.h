#pragma once
#include <optional>

#include "fusee/inference/constants.h"
#include "fusee/inference/search.h"

namespace fusee::inference {

/// Every generic effect on every side that the experiments of the case can see.
[[nodiscard]] std::vector<Cause> possible_terms(const Problem& problem);
/// Those of them that are easily confused with the effect of this id.
[[nodiscard]] std::vector<Cause> terms_like(const Problem& problem, const std::string& effect);

/// Generic terms that explain what no effect of the library does.
struct FoundTerms {
    Fit fit;                          ///< with one term or two
    std::vector<double> log_odds;     ///< of each when it was added, its cost included [nats], > 0
    std::vector<double> probability;  ///< of each among those that were fitted in its place, and none
    Split left_out;                   ///< with experiments left out
};
/// Matching pursuit: the best generic term upon the rig with build tolerances alone, each of `terms` screened and the best three fitted in
/// full; then a second one upon it in the same way, or the same term on the other side upon any of the three. None if they do not exceed
/// `least` (log evidence to beat) by kTermOdds each, if a size does not stand off 0 or is at a bound, or if experiments that would each
/// see it disagree about its size.
[[nodiscard]] std::optional<FoundTerms> pursue_terms(const Problem& problem, const Fit& null, double least, const std::vector<Cause>& terms,
                                                     const SearchOptions& options);

/// The best hypothesis again, from the build parameters of the terms that beat it: one that stopped elsewhere would make a term look
/// necessary. @return `found` with the likelier fit, and the terms if they still beat it
struct Reconsidered {
    Search found;
    std::optional<FoundTerms> terms;
};
[[nodiscard]] Reconsidered reconsidered(const Problem& problem, Search found, FoundTerms terms, unsigned jobs);

}  // namespace fusee::inference
