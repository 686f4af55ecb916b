#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "fusee/core/units.h"

namespace fusee::math {

/// A smooth function of one variable, clamped to its domain. Immutable and reentrant.
class Curve {
public:
    virtual ~Curve() = default;
    [[nodiscard]] virtual core::Range domain() const = 0;
    [[nodiscard]] virtual double value(double x) const = 0;
    /// @pre 0 <= order <= 3
    [[nodiscard]] virtual double derivative(double x, int order) const = 0;
};
using CurvePtr = std::shared_ptr<const Curve>;

/// Quintic spline (C4) through the rows. The two rows next to each end are not knots ("not-a-knot"): a quintic is reproduced, and the
/// error falls with the sixth power of the rows' spacing up to the ends; 4 to 6 rows give their polynomial.
/// @pre x ascending, at least 4 rows, finite. @throws InvalidInput naming the row
[[nodiscard]] CurvePtr make_interpolant(const std::vector<double>& x, const std::vector<double>& y);
/// Smoothing spline through noisy rows (SmoothingSpline as a Curve). @pre at least 8 rows. @throws InvalidInput naming the row
[[nodiscard]] CurvePtr make_smoothed(const std::vector<double>& x, const std::vector<double>& y);
/// A formula in `variable` ("0.9*exp(-tau)", muParser's functions) over `domain`. Returns its piecewise
/// Chebyshev interpolant, relative accuracy 1e-12 down to a thousandth of its largest value, of its first two derivatives 1e-9, of the
/// third 1e-7.
/// @throws InvalidInput naming `field` and the place: a syntax error (its character), a value that is not finite, a step or kink (the first
/// two derivatives must be continuous)
[[nodiscard]] CurvePtr make_formula(const std::string& field, const std::string& formula, const std::string& variable, core::Range domain);
/// The curve with its values multiplied by `factor`: another unit.
[[nodiscard]] CurvePtr make_scaled(CurvePtr curve, double factor);
/// Any callable with its derivatives (order 0 to 3).
[[nodiscard]] CurvePtr make_curve(std::function<double(double, int)> f, core::Range domain);

/// Checks a table for a curve: as many y as x, at least `least` rows, all finite, x ascending.
/// @throws InvalidInput naming the column, `x_name` or `y_name`, and the row as in "x[3]"
void require_table(const std::vector<double>& x, const std::vector<double>& y, std::size_t least, const std::string& x_name = "x",
                   const std::string& y_name = "y");

}  // namespace fusee::math
