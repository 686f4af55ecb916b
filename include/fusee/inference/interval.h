#pragma once
#include "fusee/inference/splits.h"

namespace fusee::inference {

/// Student's 95 % for the mean of `samples` figures; fewer than 4 count as 4, more than 6 as 6.
[[nodiscard]] double student95(std::size_t samples);

/// Half of the 95 % of x[k]: the fit's own sigma, the law's accuracy, and the spread of refits without an experiment (jackknife) as far
/// as the experiments that are left would see such a size; few say it but roughly (docs/theory/diagnosis.md, eq. 15).
[[nodiscard]] double half_interval(const Fit& fit, const Split& left_out, int k);

/// The causes whose size does not stand off 0 by twice its interval (eq. 16): experiments that would each see it disagree about it. A limit
/// (a stop) has no size of 0 and is never one of them.
[[nodiscard]] Causes contradicted(const Problem& problem, const Fit& fit, const Split& left_out);

/// The causes whose size the fit wants to be more than the effect's law allows, so that it stands for something else. No limits either.
[[nodiscard]] Causes at_bounds(const Problem& problem, const Fit& fit);

}  // namespace fusee::inference
