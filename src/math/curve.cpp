#include "fusee/math/curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "fusee/core/error.h"

namespace fusee::math {

namespace {

class Scaled final : public Curve, public EnclosedCurve {
public:
    Scaled(CurvePtr curve, double factor) : curve_(std::move(curve)), factor_(factor) {}

    [[nodiscard]] core::Range domain() const override { return curve_->domain(); }
    [[nodiscard]] double value(double x) const override { return factor_ * curve_->value(x); }
    [[nodiscard]] double derivative(double x, int order) const override { return factor_ * curve_->derivative(x, order); }
    [[nodiscard]] std::vector<double> breaks() const override { return math::breaks(*curve_); }
    [[nodiscard]] Jet over(const Interval& x, int order) const override {
        return factor_ * math::derivative(*curve_, Jet::parameter(x), order);
    }

private:
    CurvePtr curve_;
    double factor_;
};

void require_finite(const std::string& column, std::size_t row, double value) {
    if (!std::isfinite(value)) throw core::InvalidInput(fmt::format("{}[{}]", column, row), fmt::format("{:g}", value), "a finite number");
}

constexpr std::size_t kQuintic = 5;

/// B-splines of one degree on knots of any spacing (de Boor, A Practical Guide to Splines, 2001, chapters IX to XIII).
class Basis {
public:
    /// Not-a-knot: the first and last row, as often as the degree needs, and the rows at least (degree + 1)/2 rows inside.
    explicit Basis(const std::vector<double>& x) : count_(x.size()), degree_(std::min(kQuintic, x.size() - 1)) {
        const std::size_t inner = count_ - degree_ - 1;
        knots_.assign(degree_ + 1, x.front());
        const auto first = x.begin() + (kQuintic + 1) / 2;
        if (inner > 0) knots_.insert(knots_.end(), first, first + static_cast<std::ptrdiff_t>(inner));
        knots_.insert(knots_.end(), degree_ + 1, x.back());
    }

    [[nodiscard]] std::size_t degree() const { return degree_; }
    [[nodiscard]] const std::vector<double>& knots() const { return knots_; }
    /// The i with knots[i] <= x < knots[i + 1]; at the upper end the last one.
    [[nodiscard]] std::size_t span(double x) const {
        const auto begin = knots_.begin() + static_cast<std::ptrdiff_t>(degree_) + 1;
        const auto end = knots_.begin() + static_cast<std::ptrdiff_t>(count_);
        return static_cast<std::size_t>(std::upper_bound(begin, end, x) - knots_.begin()) - 1;
    }
    /// The splines of `degree` that differ from 0 in a span: numbers span - degree to span (Cox-de Boor).
    [[nodiscard]] std::array<double, kQuintic + 1> at(double x, std::size_t span, std::size_t degree) const {
        std::array<double, kQuintic + 1> values{1.0};
        for (std::size_t j = 1; j <= degree; ++j) {
            double saved = 0.0;
            for (std::size_t r = 0; r < j; ++r) {
                const double above = knots_[span + r + 1], below = knots_[span + r + 1 - j];
                const double part = values[r] / (above - below);
                values[r] = saved + (above - x) * part;
                saved = (x - below) * part;
            }
            values[j] = saved;
        }
        return values;
    }
    /// Coefficients of the derivative of a spline of `degree`, number i by backward difference, without number 0.
    [[nodiscard]] std::vector<double> derived(const std::vector<double>& coefficients, std::size_t degree) const {
        std::vector<double> result(count_, 0.0);
        for (std::size_t i = 1; i < count_; ++i) {
            const double width = knots_[i + degree] - knots_[i];
            if (width > 0.0) result[i] = static_cast<double>(degree) * (coefficients[i] - coefficients[i - 1]) / width;
        }
        return result;
    }
    /// Coefficients of the spline through the rows. The matrix is banded and totally positive: elimination needs no pivots (chapter XIII).
    [[nodiscard]] std::vector<double> through(const std::vector<double>& x, std::vector<double> y) const {
        const std::size_t width = 2 * degree_ + 1;  // column j of row i is at j - i + degree
        std::vector<double> band(count_ * width, 0.0);
        const auto entry = [&](std::size_t i, std::size_t j) -> double& { return band[i * width + j + degree_ - i]; };
        for (std::size_t i = 0; i < count_; ++i) {
            const std::size_t last = span(x[i]);
            const auto values = at(x[i], last, degree_);
            for (std::size_t r = 0; r <= degree_; ++r)
                if (values[r] != 0.0) entry(i, last - degree_ + r) = values[r];
        }
        for (std::size_t k = 0; k < count_; ++k)
            for (std::size_t i = k + 1; i < std::min(k + degree_ + 1, count_); ++i) {
                const double factor = entry(i, k) / entry(k, k);
                if (factor == 0.0) continue;
                for (std::size_t j = k + 1; j < std::min(k + degree_ + 1, count_); ++j) entry(i, j) -= factor * entry(k, j);
                y[i] -= factor * y[k];
            }
        for (std::size_t i = count_; i-- > 0;) {
            for (std::size_t j = i + 1; j < std::min(i + degree_ + 1, count_); ++j) y[i] -= entry(i, j) * y[j];
            y[i] /= entry(i, i);
        }
        return y;
    }

private:
    std::size_t count_, degree_;
    std::vector<double> knots_;
};

/// The spline as polynomials in x - knot, one per span.
class Interpolant final : public Curve, public EnclosedCurve {
public:
    Interpolant(const std::vector<double>& x, const std::vector<double>& y) {
        const Basis basis(x);
        std::vector<double> coefficients = basis.through(x, y);
        starts_.assign(basis.knots().begin() + static_cast<std::ptrdiff_t>(basis.degree()),
                       basis.knots().begin() + static_cast<std::ptrdiff_t>(x.size()));
        end_ = x.back();
        pieces_.resize(starts_.size());
        double factorial = 1.0;
        for (std::size_t order = 0; order <= basis.degree(); ++order) {
            const std::size_t degree = basis.degree() - order;
            for (std::size_t i = 0; i < starts_.size(); ++i) {
                const std::size_t span = basis.degree() + i;
                const auto values = basis.at(starts_[i], span, degree);
                for (std::size_t r = 0; r <= degree; ++r) pieces_[i][order] += values[r] * coefficients[span - degree + r] / factorial;
            }
            if (degree > 0) coefficients = basis.derived(coefficients, degree);
            factorial *= static_cast<double>(order + 1);
        }
    }

    [[nodiscard]] core::Range domain() const override { return {starts_.front(), end_}; }
    [[nodiscard]] double value(double x) const override { return derivative(x, 0); }
    [[nodiscard]] double derivative(double x, int order) const override {
        assert(order >= 0 && order <= 3);
        const double at = std::clamp(x, starts_.front(), end_);
        const auto i = static_cast<std::size_t>(std::upper_bound(starts_.begin() + 1, starts_.end(), at) - starts_.begin()) - 1;
        return polynomial(pieces_[i], order, at - starts_[i]);
    }
    [[nodiscard]] std::vector<double> breaks() const override {
        std::vector<double> all = starts_;
        all.push_back(end_);
        return all;
    }
    [[nodiscard]] Jet over(const Interval& x, int order) const override {
        const auto i = static_cast<std::size_t>(std::upper_bound(starts_.begin() + 1, starts_.end(), middle(x)) - starts_.begin()) - 1;
        return polynomial(pieces_[i], order, Jet::parameter(x) - starts_[i]);
    }

private:
    using Piece = std::array<double, kQuintic + 1>;

    /// The derivative of that order at t, by Horner's rule.
    template <class T>
    [[nodiscard]] static T polynomial(const Piece& piece, int order, const T& t) {
        T sum = 0.0;
        for (std::size_t k = kQuintic + 1; k-- > static_cast<std::size_t>(order);) {
            double coefficient = piece[k];
            for (int j = 0; j < order; ++j) coefficient *= static_cast<double>(k) - j;
            sum = sum * t + coefficient;
        }
        return sum;
    }

    std::vector<double> starts_;
    double end_ = 0.0;
    std::vector<Piece> pieces_;
};

}  // namespace

void require_table(const std::vector<double>& x, const std::vector<double>& y, std::size_t least, const std::string& x_name,
                   const std::string& y_name) {
    if (x.size() != y.size())
        throw core::InvalidInput(y_name, fmt::format("{} rows", y.size()), fmt::format("as many as {} has: {}", x_name, x.size()));
    if (x.size() < least) throw core::InvalidInput(x_name, fmt::format("{} rows", x.size()), fmt::format("at least {} rows", least));
    for (std::size_t row = 0; row < x.size(); ++row) {
        require_finite(x_name, row, x[row]);
        require_finite(y_name, row, y[row]);
        if (row > 0 && x[row] <= x[row - 1])
            throw core::InvalidInput(fmt::format("{}[{}]", x_name, row), fmt::format("{:g}", x[row]),
                                     fmt::format("above the row before, {:g}", x[row - 1]));
    }
}

CurvePtr make_scaled(CurvePtr curve, double factor) { return std::make_shared<Scaled>(std::move(curve), factor); }

std::vector<double> breaks(const Curve& curve) {
    const auto* enclosed = dynamic_cast<const EnclosedCurve*>(&curve);
    return enclosed ? enclosed->breaks() : std::vector{curve.domain().low, curve.domain().high};
}

Jet derivative(const Curve& curve, const Jet& x, int order) {
    const auto* enclosed = dynamic_cast<const EnclosedCurve*>(&curve);
    if (!enclosed) return Jet::anything();
    const Jet own = enclosed->over(x.value, order);
    return {own.value, own.slope * x.slope};
}

CurvePtr make_interpolant(const std::vector<double>& x, const std::vector<double>& y) {
    constexpr std::size_t kLeastRows = 4;
    require_table(x, y, kLeastRows);
    return std::make_shared<Interpolant>(x, y);
}

}  // namespace fusee::math
