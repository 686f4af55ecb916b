#pragma once
#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "fusee/core/units.h"
#include "fusee/math/interval.h"

namespace fusee::math {

/// A polynomial on one interval as a Chebyshev series: the interpolant through Chebyshev-Lobatto points, within a small factor of the best
/// polynomial of its degree, and its exact derivative and integral (Trefethen, Approximation Theory and Approximation
/// Practice, 2013). Immutable value.
class ChebyshevSeries {
public:
    static constexpr std::size_t kPoints = 17;
    using Values = std::array<double, kPoints>;

    /// The interpolation points, ascending, both ends included.
    [[nodiscard]] static Values points(core::Range domain);
    /// @param values at `points(domain)`
    ChebyshevSeries(core::Range domain, const Values& values);

    /// @pre x in domain() (a little beyond is extrapolation)
    [[nodiscard]] double operator()(double x) const;
    /// Value and derivative over a box: each term by the monotone pieces of its cosine. @pre the box lies in domain()
    [[nodiscard]] Jet over(const Interval& x) const;
    [[nodiscard]] ChebyshevSeries derivative() const;
    /// Integral from the lower end of the domain.
    [[nodiscard]] ChebyshevSeries integral() const;

    [[nodiscard]] core::Range domain() const { return domain_; }
    /// The size of the last two coefficients of an interpolant: the change that a higher degree would still make.
    [[nodiscard]] double tail() const;

private:
    explicit ChebyshevSeries(core::Range domain) : domain_(domain) {}

    core::Range domain_;
    std::array<double, kPoints + 1> coefficients_{};  ///< one more than points: an integral's degree is higher by 1
    std::size_t count_ = 1;                           ///< coefficients in use, >= 1; beyond them rounding only
};

struct PiecewiseOptions {
    double tolerance = 1e-13;  ///< of an interpolant, relative to the largest value in its piece
    int deepest = 10;          ///< greatest number of times that a piece is divided
};

/// A function as Chebyshev series on as many pieces as it needs. Pieces are divided until the series has converged; a function with a
/// step or kink never converges, one whose second derivative is continuous does. Immutable and reentrant; x is clamped to the domain.
class PiecewiseChebyshev {
public:
    /// @pre domain.width() > 0, f finite on it (an exception of f passes through)
    PiecewiseChebyshev(const std::function<double(double)>& f, core::Range domain, const PiecewiseOptions& options = {});

    [[nodiscard]] core::Range domain() const { return {pieces_.front().value.domain().low, pieces_.back().value.domain().high}; }
    /// @pre 0 <= order <= 3
    [[nodiscard]] double derivative(double x, int order) const;
    [[nodiscard]] double value(double x) const { return derivative(x, 0); }
    /// Integral from the lower end of the domain to x.
    [[nodiscard]] double integral(double x) const;
    /// A place where the deepest division did not converge, if any: f is not smooth there.
    [[nodiscard]] std::optional<double> rough() const { return rough_; }
    [[nodiscard]] std::size_t pieces() const { return pieces_.size(); }

    /// Boundaries of the pieces, both ends of the domain included.
    [[nodiscard]] std::vector<double> breaks() const;
    /// Derivative (order 0 to 2) over a box, and the one after it. @pre the box lies between two neighbouring breaks
    [[nodiscard]] Jet over(const Interval& x, int order) const;

private:
    struct Piece {
        explicit Piece(const ChebyshevSeries& series);
        ChebyshevSeries value, first, second, third, integral;
        double before = 0.0;  ///< integral over the pieces below
    };
    void divide(const std::function<double(double)>& f, core::Range range, const PiecewiseOptions& options, int depth);
    [[nodiscard]] static bool meet(const Piece& below, const Piece& above, double tolerance);
    [[nodiscard]] const Piece& piece(double x) const;

    std::vector<Piece> pieces_;
    double largest_ = 0.0;  ///< largest value so far
    std::optional<double> rough_;
};

}  // namespace fusee::math
