#pragma once
#include <vector>

#include "fusee/math/curve.h"
#include "fusee/math/interval.h"

namespace fusee::math {

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
