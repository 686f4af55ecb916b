#pragma once
#include <optional>

#include "fusee/inference/search.h"

namespace fusee::inference {

inline constexpr double kTermOdds = 25.0;  ///< log odds against a generic term: each has more freedom than an effect [nats]

/// Every generic term on every side that the experiments of the case can see. A ripple has a phase of its own on each side.
[[nodiscard]] std::vector<effects::Cause> possible_terms(const gap_case::Rows& rows);

/// A generic term that explains what no effect of the library does.
struct FoundTerm {
    Fit fit;
    double log_odds = 0.0;     ///< that it is there, the cost `kTermOdds` included [nats], > 0
    double probability = 0.0;  ///< among the terms that were fitted, and none
    Split left_out;            ///< with experiments left out
};
/// The best generic term upon the rig with build tolerances alone: every term screened, the best four fitted in full. None if it does not
/// exceed `least` (log evidence of what it has to beat) by kTermOdds, if its size does not stand off 0, or if experiments that
/// would each see it disagree about its size.
[[nodiscard]] std::optional<FoundTerm> pursue_term(const Problem& problem, const Fit& null, double least, const SearchOptions& options);

}  // namespace fusee::inference
