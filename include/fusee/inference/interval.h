#pragma once
#include "fusee/inference/splits.h"

namespace fusee::inference {

/// Student's 95 % for the mean of `samples` figures; clamped to 4 to 6 samples.
[[nodiscard]] double student95(std::size_t samples);

/// Half width of the 95 % interval of x[k]: sigma of the fit, accuracy of the law, and spread of refits without one experiment (jackknife),
/// as far as the remaining experiments would see such a size; few experiments give a rough value (docs/theory/diagnosis.md, eq. 15).
[[nodiscard]] double half_interval(const Fit& fit, const Split& left_out, int k);

/// The causes whose size is within twice its interval of 0 (eq. 16): experiments that would each see it disagree. A limit
/// (a stop) has no size of 0 and is never contradicted.
[[nodiscard]] Causes contradicted(const Problem& problem, const Fit& fit, const Split& left_out);

/// The causes whose size is at an end of its range, so that the true cause is another one; a limit at the far end is no effect at all.
[[nodiscard]] Causes at_bounds(const Problem& problem, const Fit& fit);

}  // namespace fusee::inference
