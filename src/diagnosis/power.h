#pragma once
#include <vector>

#include "fusee/diagnosis/diagnosis.h"
#include "fusee/inference/problem.h"

namespace fusee::diagnosis {

/// The length of a cause's mark, in sigmas, from which the cause is named in 95 of 100 cases (docs/theory/diagnosis.md, eq. 19): its
/// evidence then exceeds the odds against an effect three times. @param per_scale length of the mark of a usual size
[[nodiscard]] double named_length(double per_scale);

/// The power of a case for every effect of the library on each side; no size of an effect that no experiment of the case sees.
[[nodiscard]] std::vector<Power> powers_of(const inference::Problem& problem, const Isolability& isolability);
/// The causes of which a usual size would not have been named.
[[nodiscard]] std::vector<inference::Cause> not_shown(const std::vector<Power>& powers);

}  // namespace fusee::diagnosis
