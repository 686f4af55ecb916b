#pragma once
#include <memory>
#include <string>
#include <vector>

#include "fusee/core/units.h"
#include "fusee/math/interval.h"

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
/// A formula in `variable` ("0.9*exp(-tau)", muParser's functions) over `domain`. Returns its piecewise
/// Chebyshev interpolant, relative accuracy 1e-12 down to a thousandth of its largest value, of its first two derivatives 1e-9, of the
/// third 1e-7.
/// @throws InvalidInput naming `field` and the place: a syntax error (its character), a value that is not finite, a step or kink (the first
/// two derivatives must be continuous)
[[nodiscard]] CurvePtr make_formula(const std::string& field, const std::string& formula, const std::string& variable, core::Range domain);
/// The curve with its values multiplied by `factor`: another unit.
[[nodiscard]] CurvePtr make_scaled(CurvePtr curve, double factor);

/// Checks a table for a curve: as many y as x, at least `least` rows, all finite, x ascending.
/// @throws InvalidInput naming the column, `x_name` or `y_name`, and the row as in "x[3]"
void require_table(const std::vector<double>& x, const std::vector<double>& y, std::size_t least, const std::string& x_name = "x",
                   const std::string& y_name = "y");

/// A `Curve` with bounds: between two neighbouring breaks it is one polynomial.
class EnclosedCurve {
public:
    virtual ~EnclosedCurve() = default;
    /// Boundaries of the polynomials, both ends of the domain included, ascending.
    [[nodiscard]] virtual std::vector<double> breaks() const = 0;
    /// The derivative of that order over a box of x, and the one after it.
    /// @pre the box lies between two neighbouring breaks, 0 <= order <= 2
    [[nodiscard]] virtual Jet over(const Interval& x, int order) const = 0;
};

/// The breaks of a curve; only the ends of its domain if it has no bounds.
[[nodiscard]] std::vector<double> breaks(const Curve& curve);

/// A curve's derivative for formulas of any number type. Jet::anything() if the curve has no bounds. @pre as `EnclosedCurve::over`
[[nodiscard]] inline double derivative(const Curve& curve, double x, int order) { return curve.derivative(x, order); }
[[nodiscard]] Jet derivative(const Curve& curve, const Jet& x, int order);

}  // namespace fusee::math
