#pragma once
#include <vector>

#include "fusee/inference/fit.h"

namespace fusee::inference {

/// x at which a fit of the last of `causes` upon `base` may start: the x of `base` with every start of the size and every try of the
/// further parameters. Of a ripple instead the best counts with amplitude and phase in the linear model, fitted to the rows `kept`.
/// Where `base` has the same cause on the other side, its figures are a start too: the two sides are of one design.
/// @return not empty
[[nodiscard]] std::vector<Eigen::VectorXd> starts_upon(const Problem& problem, const Fit& base, const Causes& causes,
                                                       const std::vector<bool>* kept);

}  // namespace fusee::inference
