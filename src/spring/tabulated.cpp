#include <fmt/format.h>

#include <cmath>

#include "fusee/core/error.h"
#include "fusee/math/curve.h"
#include "fusee/math/smoothing_spline.h"
#include "fusee/spring/enclosure.h"
#include "fusee/spring/potential.h"

namespace fusee::spring {

namespace {

constexpr std::size_t kLeastRows = 8;

class Tabulated final : public Potential, public EnclosedPotential {
public:
    explicit Tabulated(math::SmoothingSpline spline) : spline_(std::move(spline)) {}

    [[nodiscard]] core::Range domain() const override { return spline_.domain(); }
    [[nodiscard]] double energy(double x) const override { return spline_.integral(x); }
    [[nodiscard]] double force(double x) const override { return spline_.value(x); }
    [[nodiscard]] double stiffness(double x) const override { return spline_.derivative(x, 1); }
    [[nodiscard]] double slope(double x) const override { return spline_.derivative(x, 2); }
    [[nodiscard]] std::vector<double> breaks() const override { return spline_.breaks(); }
    [[nodiscard]] PotentialJet over(const math::Interval& x) const override {
        constexpr int kIntegral = -1;
        return {spline_.over(x, kIntegral), spline_.over(x, 0), spline_.over(x, 1), spline_.over(x, 2)};
    }

private:
    math::SmoothingSpline spline_;
};

}  // namespace

PotentialPtr make_tabulated(const std::vector<double>& x, const std::vector<double>& force, const TableOptions& options) {
    math::require_table(x, force, kLeastRows, "x", "force");
    core::require_within("knots", options.knots, 1, 1000);
    if (!std::isfinite(options.smoothing)) throw core::InvalidInput("smoothing", fmt::format("{:g}", options.smoothing), "a finite number");
    return std::make_shared<Tabulated>(math::SmoothingSpline(x, force, {.intervals = options.knots, .lambda = options.smoothing}));
}

}  // namespace fusee::spring
