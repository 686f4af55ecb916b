#pragma once
#include <optional>

#include "fusee/inference/search.h"

namespace fusee::diagnosis {

/// A hypothesis whose effects stand although it does not explain everything.
struct Standing {
    inference::Fit fit;         ///< of these effects and no others
    inference::Split left_out;  ///< with experiments left out
};

/// The effects of the best hypothesis that stand, fitted without the others: those of which the ranking is sure, whose size is at no bound
/// and about which refits without one experiment each agree, and for which the experiments that the fit explains pay
/// (docs/theory/diagnosis.md, eq. 21). None if no effect is left.
[[nodiscard]] std::optional<Standing> standing_part(const inference::Problem& problem, const inference::Search& search, unsigned jobs);

}  // namespace fusee::diagnosis
