#pragma once
#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

#include "fusee/math/curve.h"

namespace fusee::fixtures {

/// A function with its derivatives (order 0 to 3) as a curve without bounds.
class Callable final : public math::Curve {
public:
    Callable(std::function<double(double, int)> f, core::Range domain) : f_(std::move(f)), domain_(domain) {}

    [[nodiscard]] core::Range domain() const override { return domain_; }
    [[nodiscard]] double value(double x) const override { return derivative(x, 0); }
    [[nodiscard]] double derivative(double x, int order) const override { return f_(std::clamp(x, domain_.low, domain_.high), order); }

private:
    std::function<double(double, int)> f_;
    core::Range domain_;
};

[[nodiscard]] inline math::CurvePtr make_curve(std::function<double(double, int)> f, core::Range domain) {
    return std::make_shared<Callable>(std::move(f), domain);
}

}  // namespace fusee::fixtures
