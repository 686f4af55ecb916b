#include <fmt/format.h>

#include <array>
#include <cmath>
#include <mutex>

#include "fusee/core/error.h"
#include "fusee/math/chebyshev.h"
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

/// The last fits: a search asks for those of the same rows thousands of times, and one takes some milliseconds.
class Fits {
public:
    [[nodiscard]] PotentialPtr find(const std::vector<double>& x, const std::vector<double>& force, const TableOptions& options) {
        const std::scoped_lock lock(mutex_);
        for (const Fit& fit : kept_)
            if (fit.spring && fit.options.knots == options.knots && fit.options.smoothing == options.smoothing && fit.x == x &&
                fit.force == force)
                return fit.spring;
        return nullptr;
    }
    void keep(const std::vector<double>& x, const std::vector<double>& force, const TableOptions& options, const PotentialPtr& spring) {
        const std::scoped_lock lock(mutex_);
        kept_[next_++ % kept_.size()] = {x, force, options, spring};
    }

private:
    struct Fit {
        std::vector<double> x, force;
        TableOptions options;
        PotentialPtr spring;
    };
    std::mutex mutex_;
    std::array<Fit, 8> kept_;  ///< both springs of a joint, and those of a few more
    std::size_t next_ = 0;
};

Fits& fits() {
    static Fits all;
    return all;
}

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

PotentialPtr make_tabulated(const std::vector<double>& x, const std::vector<double>& force, const TableOptions& options) {
    math::require_table(x, force, kLeastRows, "x", "force");
    core::require_within("knots", options.knots, 1, 1000);
    if (!std::isfinite(options.smoothing)) throw core::InvalidInput("smoothing", fmt::format("{:g}", options.smoothing), "a finite number");
    if (PotentialPtr known = fits().find(x, force, options)) return known;
    auto spring = std::make_shared<Tabulated>(math::SmoothingSpline(x, force, {.intervals = options.knots, .lambda = options.smoothing}));
    fits().keep(x, force, options, spring);
    return spring;
}

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
