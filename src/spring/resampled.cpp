#include <fmt/format.h>

#include <cmath>

#include "fusee/core/error.h"
#include "fusee/math/chebyshev.h"
#include "fusee/spring/enclosure.h"
#include "fusee/spring/potential.h"

namespace fusee::spring {

namespace {

class Resampled final : public Potential, public EnclosedPotential {
public:
    Resampled(math::PiecewiseChebyshev force, double energy_low) : force_(std::move(force)), energy_low_(energy_low) {}

    [[nodiscard]] core::Range domain() const override { return force_.domain(); }
    [[nodiscard]] double energy(double x) const override { return energy_low_ + force_.integral(x); }
    [[nodiscard]] double force(double x) const override { return force_.value(x); }
    [[nodiscard]] double stiffness(double x) const override { return force_.derivative(x, 1); }
    [[nodiscard]] double slope(double x) const override { return force_.derivative(x, 2); }
    [[nodiscard]] std::vector<double> breaks() const override { return force_.breaks(); }
    [[nodiscard]] PotentialJet over(const math::Interval& x) const override {
        const double middle = math::middle(x);
        const math::Jet force = force_.over(x, 0), stiffness = force_.over(x, 1);
        const math::Interval energy = energy_low_ + force_.integral(middle) + force.value * (x - middle);
        return {{energy, force.value}, force, stiffness, force_.over(x, 2)};
    }

private:
    math::PiecewiseChebyshev force_;
    double energy_low_;
};

// Near an asymptote the load is ill-conditioned in the angle, and the force has that rounding: then fewer digits must suffice.
constexpr double kTolerances[] = {1e-13, 1e-11, 1e-9};

}  // namespace

PotentialPtr make_of_torque(const std::string& key, const std::function<double(double)>& torque, core::Range domain) {
    const auto finite = [&](double x) {
        const double value = torque(x);
        if (!std::isfinite(value)) throw core::InvalidInput(key, fmt::format("{:g} at {:.6g} rad", value, x), "a finite torque");
        return value;
    };
    double rough = 0.0;
    for (const double tolerance : kTolerances) {
        math::PiecewiseChebyshev force(finite, domain, {.tolerance = tolerance});
        if (!force.rough()) return std::make_shared<Resampled>(std::move(force), 0.0);
        rough = *force.rough();
    }
    throw core::InvalidInput(key, fmt::format("a step or kink at {:.6g} rad", rough), "a torque with two continuous derivatives");
}

PotentialPtr resampled(PotentialPtr spring) {
    for (const double tolerance : kTolerances) {
        math::PiecewiseChebyshev force([&](double x) { return spring->force(x); }, spring->domain(), {.tolerance = tolerance});
        if (!force.rough()) return std::make_shared<Resampled>(std::move(force), spring->energy(spring->domain().low));
    }
    return spring;
}

}  // namespace fusee::spring
