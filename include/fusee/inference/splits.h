#pragma once
#include <vector>

#include "fusee/inference/fit.h"

namespace fusee::inference {

inline constexpr int kFolds = 4;
/// Fold of each residual: whole set points of an experiment, whole runs of a path.
[[nodiscard]] std::vector<int> folds(const Problem& problem);

/// Refits, each without one part of the rows.
struct Split {
    Eigen::VectorXd residual;            ///< of every row by the refit without it
    std::vector<Eigen::VectorXd> x;      ///< of each refit; empty for a part without rows
    std::vector<Eigen::VectorXd> sigma;  ///< of the x of each refit, from its rows
};
/// Every fold predicted by a refit without it (nested: the refit starts at `fit` and takes Gauss-Newton steps on the rows of the other
/// folds).
[[nodiscard]] Split held_out(const Problem& problem, const Fit& fit, unsigned jobs);
/// The same with whole experiments left out.
[[nodiscard]] Split experiments_left_out(const Problem& problem, const Fit& fit, unsigned jobs);

}  // namespace fusee::inference
