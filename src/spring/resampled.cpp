#include "fusee/math/chebyshev.h"
#include "fusee/spring/potential.h"

namespace fusee::spring {

namespace {

class Resampled final : public Potential {
public:
    Resampled(math::PiecewiseChebyshev force, double energy_low) : force_(std::move(force)), energy_low_(energy_low) {}

    [[nodiscard]] core::Range domain() const override { return force_.domain(); }
    [[nodiscard]] double energy(double x) const override { return energy_low_ + force_.integral(x); }
    [[nodiscard]] double force(double x) const override { return force_.value(x); }
    [[nodiscard]] double stiffness(double x) const override { return force_.derivative(x, 1); }
    [[nodiscard]] double slope(double x) const override { return force_.derivative(x, 2); }

private:
    math::PiecewiseChebyshev force_;
    double energy_low_;
};

}  // namespace

PotentialPtr resampled(PotentialPtr spring) {
    // Near an asymptote the load is ill-conditioned in the angle, and the force has that rounding: then fewer digits must suffice.
    for (const double tolerance : {1e-13, 1e-11, 1e-9}) {
        math::PiecewiseChebyshev force([&](double x) { return spring->force(x); }, spring->domain(), {.tolerance = tolerance});
        if (!force.rough()) return std::make_shared<Resampled>(std::move(force), spring->energy(spring->domain().low));
    }
    return spring;
}

}  // namespace fusee::spring
