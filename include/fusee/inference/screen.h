#pragma once
#include <vector>

#include "fusee/inference/fit.h"

namespace fusee::inference {

/// A hypothesis with approximate parameters.
struct Guess {
    Causes causes;
    Eigen::VectorXd x;
    double cost = 0.0;  ///< estimated: build parameters follow in the linear model
};

/// Every effect of the library on every side.
[[nodiscard]] std::vector<effects::Cause> causes_of_library();
/// Every effect on every side that the experiments of the case can see.
[[nodiscard]] std::vector<effects::Cause> possible_causes(const gap_case::Rows& rows);

/// Adds each of `causes` to what `base` has, at its sizes to start with and one Gauss-Newton step, the rest of x following in
/// the linear model of `base`. Sorted by cost.
[[nodiscard]] std::vector<Guess> screen(const Problem& problem, const Fit& base, const std::vector<effects::Cause>& causes, unsigned jobs);

}  // namespace fusee::inference
