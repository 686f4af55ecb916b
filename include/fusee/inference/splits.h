#pragma once
#include <vector>

#include "fusee/inference/fit.h"

namespace fusee::inference {

inline constexpr int kFolds = 4;
/// Of each residual, the fold that it is held out in: whole set points of an experiment, whole stretches of a path.
[[nodiscard]] std::vector<int> folds(const Problem& problem);

/// Refits without a part of the rows, one part after the other.
struct Split {
    Eigen::VectorXd residual;            ///< of every row by the refit that has not seen it
    std::vector<Eigen::VectorXd> x;      ///< of each refit; empty for a part without rows
    std::vector<Eigen::VectorXd> sigma;  ///< of each refit's x, by the rows that it has seen
};
/// Every fold predicted by a refit without it (nested: the refit begins at `fit` and takes Gauss-Newton steps on the other folds' rows).
[[nodiscard]] Split held_out(const Problem& problem, const Fit& fit, unsigned jobs);
/// The same with whole experiments left out.
[[nodiscard]] Split experiments_left_out(const Problem& problem, const Fit& fit, unsigned jobs);

}  // namespace fusee::inference
