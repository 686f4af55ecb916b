#pragma once
#include <Eigen/Core>
#include <functional>
#include <vector>

#include "fusee/core/units.h"

namespace fusee::inference {

/// Parameters whose residuals' squares are to sum up to the least.
struct LeastSquares {
    int residuals = 0;
    /// Sets the residuals at a place and, unless `slopes` is null, their slopes, row by row.
    std::function<void(const double* at, double* residuals, double* slopes)> evaluate;
    std::vector<core::Range> last;  ///< of the last parameters; the others are free
    int steps = 0;                  ///< at most
};

}  // namespace fusee::inference

/// The one function of the module fusee_ceres.so, which `fit` loads. @param x where it begins, and then where it ended
extern "C" [[gnu::visibility("default")]] void fusee_least_squares(const fusee::inference::LeastSquares& problem, Eigen::VectorXd& x);
