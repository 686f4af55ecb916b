#pragma once
#include <vector>

#include "fusee/diagnosis/diagnosis.h"
#include "fusee/inference/search.h"

namespace fusee::diagnosis {

/// The best hypothesis with one of its causes replaced by another of its isolability class, for each that the ranking lacks, in full fits.
[[nodiscard]] std::vector<inference::Fit> class_rivals(const inference::Problem& problem, const inference::Search& search,
                                                       const Isolability& isolability, unsigned jobs);

/// Places in the ranking of the causes that nothing distinguishes from the best hypothesis: the rows of the case leave less than 3 sigma
/// between the two, or a probability that is worth an experiment, and no measurement of the menu is expected to tell one from the other
/// (docs/theory/isolability.md, "Classes"); also a size for each side in the place of one for both, if the two differ. Empty if the model
/// has no menu. Of a model whose usual sizes are a guess: those that predict the rows of the case as the best one does, to less than 3
/// sigma. At most three, the likeliest.
[[nodiscard]] std::vector<std::size_t> indistinct(const inference::Problem& problem, const inference::Search& search, unsigned jobs);

}  // namespace fusee::diagnosis
