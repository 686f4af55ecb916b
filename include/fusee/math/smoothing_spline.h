#pragma once
#include <array>
#include <vector>

#include "fusee/core/units.h"
#include "fusee/math/interval.h"

namespace fusee::math {

struct SmoothingOptions {
    int intervals = 16;    ///< of the uniform knots over the data's range, >= 1
    double lambda = -1.0;  ///< weight of the roughness penalty, >= 0; below 0: chosen by generalised cross-validation
};

/// Quintic smoothing spline (C4) through noisy rows: least squares on uniform B-splines with a penalty on the third differences of their
/// coefficients, lambda sum (d^3 c)^2 (Eilers & Marx 1996), so that a large lambda gives the best parabola. lambda minimises the robust
/// score n RSS/(n - 1.4 edf)^2: plain cross-validation sometimes undersmooths (Kim & Gu 2004). Immutable and reentrant; x is clamped to
/// the domain.
class SmoothingSpline {
public:
    /// @pre x ascending and finite, y finite, as many as x, at least 3 rows (asserted: callers report their rows)
    SmoothingSpline(const std::vector<double>& x, const std::vector<double>& y, const SmoothingOptions& options = {});

    [[nodiscard]] core::Range domain() const { return domain_; }
    [[nodiscard]] double value(double x) const { return derivative(x, 0); }
    /// @pre 0 <= order <= 3
    [[nodiscard]] double derivative(double x, int order) const;
    /// Integral from the lower end of the domain to x, exact.
    [[nodiscard]] double integral(double x) const;

    /// The knots, both ends of the domain included: between two of them all of the above are polynomials.
    [[nodiscard]] std::vector<double> breaks() const;
    /// Derivative (order 0 to 2; -1: the integral) over a box, and the one after it. @pre the box lies between two neighbouring breaks
    [[nodiscard]] Jet over(const Interval& x, int order) const;

    [[nodiscard]] double lambda() const { return lambda_; }
    /// Effective number of parameters, the trace of the smoother: 3 (a parabola) to intervals + 5.
    [[nodiscard]] double effective_parameters() const { return effective_parameters_; }
    /// Estimated standard deviation of the rows' noise, sqrt(RSS/(n - edf)); 0 if n - edf <= 0.5.
    [[nodiscard]] double noise() const { return noise_; }

private:
    [[nodiscard]] double evaluate(const std::vector<double>& coefficients, int degree, double x) const;
    [[nodiscard]] const std::vector<double>& coefficients(int order) const {
        return order < 0 ? integral_ : derivatives_[static_cast<std::size_t>(order)];
    }

    core::Range domain_;
    double step_ = 0.0;
    double lambda_ = 0.0, effective_parameters_ = 0.0, noise_ = 0.0;
    std::array<std::vector<double>, 4> derivatives_;  ///< coefficients of value, 1st, 2nd and 3rd derivative: degrees 5, 4, 3, 2
    std::vector<double> integral_;                    ///< degree 6
};

}  // namespace fusee::math
