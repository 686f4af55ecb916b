#pragma once
#include <vector>

#include "fusee/inference/constants.h"
#include "law.h"

namespace fusee::subsystem {

/// Least squares with Huber's loss: residuals beyond 3 robust deviations count linearly.
struct Fit {
    Values values;                                ///< every parameter
    std::vector<std::size_t> free;                ///< the fitted parameters
    std::vector<std::vector<double>> covariance;  ///< of the fitted parameters for rows of deviation 1 that are independent
    double cost = 0.0;                            ///< Huber cost: sum of squares, far ones linear
    double rows = 0.0;
};

/// Sums of squared residuals of each block, in sigma, and each block's number of rows.
struct Misfit {
    std::vector<double> squares, rows;
    [[nodiscard]] double mean_square(const std::vector<std::size_t>& of_blocks) const;
    [[nodiscard]] double mean_square(std::size_t block) const { return squares[block] / rows[block]; }
    /// Root mean square over all blocks.
    [[nodiscard]] double gap() const;
};
[[nodiscard]] Misfit misfit(const Law& law, const Values& values);
/// (measured - predicted)/sigma of a record.
[[nodiscard]] std::vector<double> residuals_of(const Law& law, std::size_t record, const Values& values);

/// (null value - value)/prior of a parameter; 0 if any value is plausible.
[[nodiscard]] double prior_residual(const Parameter& parameter, double value);

/// All parameters at their null values, the nominal ones at their starts.
[[nodiscard]] Values start_values(const Law& law);
/// The free parameters of a hypothesis: the nominal ones and those of its effects (indices into law.effects).
[[nodiscard]] std::vector<std::size_t> free_parameters(const Law& law, const std::vector<std::size_t>& effects);

/// Levenberg-Marquardt (D. W. Marquardt, SIAM J. Appl. Math. 11, 1963) on forward differences, steps cut at the parameters' bounds, the
/// loss by reweighting. @param kept the blocks to fit, by index
[[nodiscard]] Fit fit(const Law& law, const std::vector<std::size_t>& kept, const std::vector<std::size_t>& free, const Values& start,
                      int most_steps = inference::kFitSteps);
/// The best fit from all combinations of starts: of the effect parameters, or of the nominal ones where no other is free.
[[nodiscard]] Fit fit_from_all_starts(const Law& law, const std::vector<std::size_t>& kept, const std::vector<std::size_t>& free,
                                      const Values& nominal);

}  // namespace fusee::subsystem
