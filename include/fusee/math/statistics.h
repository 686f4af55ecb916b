#pragma once
#include <cstddef>
#include <vector>

#include "fusee/core/units.h"

namespace fusee::math {

/// The middle value; of an even count the mean of the two middle ones. @pre not empty
[[nodiscard]] double median(std::vector<double> values);
/// The middle value; of an even count the upper one of the two middle ones. @pre not empty
[[nodiscard]] double upper_median(std::vector<double> values);
/// Linear between the two nearest values; share 0 is the first, 1 the last. @pre sorted, not empty, 0 <= share <= 1
[[nodiscard]] double quantile(const std::vector<double>& sorted, double share);

/// Values in the order of their measurement, each with the standard deviation that its noise is said to have; empty sigma: 1.
struct Series {
    std::vector<double> values, sigma;
};
/// How many times their sigma the values of smooth series scatter: the median of their differences of this order, so that neither a
/// smooth course nor a few steps count. NaN: too few rows.
[[nodiscard]] double scatter(const std::vector<Series>& series, int order);
/// The least of `scatter` from the third to the sixth differences: of coarse rows the lower ones still hold the course.
[[nodiscard]] double least_scatter(const std::vector<Series>& series);
/// The same of repeats: the values of each group are of one set point. NaN: too few.
[[nodiscard]] double scatter_of_repeats(const std::vector<Series>& groups);
/// The factor upon sigma, with what was stated as the prior of an estimate: 1 unless the rows scatter clearly more than that. A smaller
/// scatter lowers nothing, since rows that were filtered hide their errors. @param scatter NaN: nothing was measured
[[nodiscard]] double noise_factor(double scatter);

/// t with P(|T| <= t) = confidence. @pre 0 < confidence < 1, freedom >= 1
[[nodiscard]] double student_quantile(double confidence, std::size_t freedom);
/// P(F > f) of the F distribution. @pre f >= 0
[[nodiscard]] double f_tail(double f, std::size_t numerator_freedom, std::size_t denominator_freedom);

/// y = sum_j b_j x_j + noise, all columns of equal length.
struct LinearModel {
    std::vector<std::vector<double>> x;  ///< one column per coefficient; a constant is a column of ones
    std::vector<double> y;
    /// Columns correlated with x but not with the noise, as many as x; empty: x itself. Needed if x is measured with the same noise as y:
    /// least squares would be biased (docs/theory/identification.md).
    std::vector<std::vector<double>> instruments;
    std::vector<double> weights;  ///< inverse variances up to a common factor, > 0; empty: all equal
};

/// Estimates and their uncertainty.
struct LinearFit {
    std::vector<double> coefficients;             ///< b_j
    std::vector<std::vector<double>> covariance;  ///< of the coefficients
    std::vector<std::vector<double>> cofactors;   ///< the covariance for a deviation of 1
    std::vector<double> residuals;                ///< y - sum b_j x_j
    double deviation = 0.0;                       ///< of a row of weight 1
    std::size_t freedom = 0;                      ///< rows - coefficients

    /// Student's t interval of b_j.
    [[nodiscard]] core::Range interval(std::size_t j, double confidence = 0.95) const;
    /// Student's t interval of sum_j b_j at_j: a point of a line's band.
    [[nodiscard]] core::Range interval_at(const std::vector<double>& at, double confidence = 0.95) const;
};

/// Weighted least squares, or its form with instruments (Theil's two-stage least squares with as many instruments as coefficients).
/// @throws core::InvalidInput if there are no more rows than coefficients, or the columns depend on each other
[[nodiscard]] LinearFit fit_linear(const LinearModel& model);

/// Huber's fit (P. J. Huber, Ann. Math. Statist. 35, 1964): residuals beyond 1.345 deviations count linearly, not as squares;
/// 95 % efficient for normal noise. Solved by reweighting.
struct RobustFit {
    std::vector<double> coefficients;
    std::vector<double> scores;  ///< residuals sqrt(weight) / deviation: large for outliers
    double deviation = 0.0;      ///< 1.4826 times the median of |residuals| sqrt(weight)
};
/// @throws core::InvalidInput as fit_linear
[[nodiscard]] RobustFit fit_robust(const LinearModel& model);

}  // namespace fusee::math
