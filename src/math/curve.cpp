#include "fusee/math/curve.h"

#include <fmt/format.h>

#include <algorithm>
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

}  // namespace fusee::math
