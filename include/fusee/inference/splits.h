#pragma once
#include <vector>

#include "fusee/inference/constants.h"
#include "fusee/inference/fit.h"

namespace fusee::inference {

/// Fold of each residual: the blocks of each experiment (Place::block) in turn.
[[nodiscard]] std::vector<int> folds(const Problem& problem);

/// Refits, each without one part of the rows.
struct Split {
    Eigen::VectorXd residual;            ///< of every row by the refit without it
    Eigen::VectorXd expected;            ///< root mean square of `residual` as that refit expects it: spread and uncertainty of its x
    std::vector<Eigen::VectorXd> x;      ///< of each refit; empty for a part without rows
    std::vector<Eigen::VectorXd> sigma;  ///< of the x of each refit, from its rows
    std::vector<double> improvement;     ///< by which the start at the fit of all rows ends lower than the start without the part; >= 0
};
/// Every fold predicted by a refit without it. A refit begins at the nominal rig and adds the causes of `fit` one after the other from
/// their own starts, so that no row of the part is looked at; it ends with a step that lowers the cost (eq. 10) on its rows by no more than
/// 0.01. A second descent begins at `fit`; where it ends lower on the rows of the refit, the first start has missed the optimum, and it
/// counts.
/// @param null the fit without effects: its slopes
[[nodiscard]] Split held_out(const Problem& problem, const Fit& null, const Fit& fit, unsigned jobs);
/// The same with whole experiments left out.
[[nodiscard]] Split experiments_left_out(const Problem& problem, const Fit& null, const Fit& fit, unsigned jobs);

}  // namespace fusee::inference
