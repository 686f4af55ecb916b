#pragma once
#include <vector>

#include "fusee/inference/search.h"

namespace fusee::inference {

/// Log evidence of a hypothesis less the odds against it (docs/theory/diagnosis.md, eq. 13 and 14) [nats]. A build parameter that no
/// workshop misses so far is a cause that the hypothesis does not name: it costs as much as one.
[[nodiscard]] double score(const Problem& problem, const Fit& fit);
void sort_by_score(const Problem& problem, std::vector<Fit>& fits);

/// The hypotheses whose sizes stand, best first, with what the experiments left out say of the first ones.
[[nodiscard]] Search ranked(const Problem& problem, std::vector<Fit> fits, const SearchOptions& options);

}  // namespace fusee::inference
