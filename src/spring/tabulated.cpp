#include <fmt/format.h>

#include <cmath>

#include "fusee/core/error.h"
#include "fusee/math/smoothing_spline.h"
#include "fusee/spring/potential.h"

namespace fusee::spring {

namespace {

constexpr std::size_t kLeastRows = 8;

class Tabulated final : public Potential {
public:
    explicit Tabulated(math::SmoothingSpline spline) : spline_(std::move(spline)) {}

    [[nodiscard]] core::Range domain() const override { return spline_.domain(); }
    [[nodiscard]] double energy(double x) const override { return spline_.integral(x); }
    [[nodiscard]] double force(double x) const override { return spline_.value(x); }
    [[nodiscard]] double stiffness(double x) const override { return spline_.derivative(x, 1); }
    [[nodiscard]] double slope(double x) const override { return spline_.derivative(x, 2); }

private:
    math::SmoothingSpline spline_;
};

void require_finite(const char* column, std::size_t row, double value) {
    if (!std::isfinite(value)) throw core::InvalidInput(fmt::format("{}[{}]", column, row), fmt::format("{:g}", value), "a finite number");
}

}  // namespace

PotentialPtr make_tabulated(const std::vector<double>& x, const std::vector<double>& force, const TableOptions& options) {
    if (x.size() != force.size())
        throw core::InvalidInput("force", fmt::format("{} rows", force.size()), fmt::format("as many as x has: {}", x.size()));
    if (x.size() < kLeastRows) throw core::InvalidInput("x", fmt::format("{} rows", x.size()), fmt::format("at least {} rows", kLeastRows));
    for (std::size_t row = 0; row < x.size(); ++row) {
        require_finite("x", row, x[row]);
        require_finite("force", row, force[row]);
        if (row > 0 && x[row] <= x[row - 1])
            throw core::InvalidInput(fmt::format("x[{}]", row), fmt::format("{:g}", x[row]),
                                     fmt::format("above the row before, {:g}", x[row - 1]));
    }
    core::require_within("knots", options.knots, 1, 1000);
    if (!std::isfinite(options.smoothing)) throw core::InvalidInput("smoothing", fmt::format("{:g}", options.smoothing), "a finite number");
    return std::make_shared<Tabulated>(math::SmoothingSpline(x, force, {.intervals = options.knots, .lambda = options.smoothing}));
}

}  // namespace fusee::spring
