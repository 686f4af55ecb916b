#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/core/error.h"
#include "fusee/math/interval.h"
#include "fusee/math/roots.h"
#include "fusee/spring/base_spring.h"
#include "fusee/spring/potential.h"

// Equation numbers: docs/theory/springs.md.
namespace fusee::spring {

namespace {

/// A quantity at one nominal angle with its derivatives by that angle.
struct Jet {
    double value = 0.0, first = 0.0, second = 0.0, third = 0.0;
};

/// The cam of the nominal law and base spring.
class NominalCam {
public:
    NominalCam(PotentialPtr law, const BaseSpring& base) : law_(std::move(law)), base_(base) {}

    [[nodiscard]] core::Range domain() const { return law_->domain(); }
    /// Deflection of the base spring beyond its preload, and its derivatives: energy and force of both agree (eq. 24).
    [[nodiscard]] Jet deflection(double x) const {
        const double state = base_.state(law_->energy(x)), load = base_.rate * state;
        Jet c;
        c.value = state - base_.preload;
        c.first = law_->force(x) / load;
        c.second = (law_->stiffness(x) - base_.rate * c.first * c.first) / load;
        c.third = (law_->slope(x) - 3.0 * base_.rate * c.first * c.second) / load;
        return c;
    }
    /// Value and slope alone.
    [[nodiscard]] math::Tangent turned(double x) const {
        const double state = base_.state(law_->energy(x));
        return {state - base_.preload, law_->force(x) / (base_.rate * state)};
    }

private:
    PotentialPtr law_;
    BaseSpring base_;
};

/// The nominal angle x identifies the point of the cam. Built deflection of the capstan X = x + wider c(x), built state of the base spring
/// s = c(x) + longer (x - x_low) + preload (eq. 25): a larger arm lengthens the cable that a spool pays out or a cam winds in.
class BuiltSpring final : public Potential {
public:
    BuiltSpring(NominalCam cam, double rate, double preload, double wider, double longer)
        : cam_(std::move(cam)), rate_(rate), preload_(preload), wider_(wider), longer_(longer), nominal_(cam_.domain()) {
        domain_ = {nominal_.low, nominal_.high + wider_ * cam_.turned(nominal_.high).value};
    }

    [[nodiscard]] core::Range domain() const override { return domain_; }
    [[nodiscard]] double energy(double x) const override {
        const double at = nominal_angle(x);
        const double stretched = cam_.turned(at).value + longer_ * (at - nominal_.low);
        return rate_ * stretched * (preload_ + 0.5 * stretched);
    }
    [[nodiscard]] double force(double x) const override {
        const double at = nominal_angle(x);
        const math::Tangent c = cam_.turned(at);
        const double state = c.value + longer_ * (at - nominal_.low) + preload_;
        return rate_ * state * (c.slope + longer_) / (1.0 + wider_ * c.slope);
    }
    [[nodiscard]] double stiffness(double x) const override { return at(x).second; }
    [[nodiscard]] double slope(double x) const override { return at(x).third; }

private:
    /// The point of the cam at built deflection X.
    [[nodiscard]] double nominal_angle(double built) const {
        const double x = std::clamp(built, domain_.low, domain_.high);
        if (wider_ == 0.0) return x;
        const auto excess = [&](double at) {
            const math::Tangent c = cam_.turned(at);
            return math::Tangent{at + wider_ * c.value - x, 1.0 + wider_ * c.slope};
        };
        const double share = (x - domain_.low) / domain_.width();
        return math::rising_root(excess, nominal_.low, nominal_.high, std::lerp(nominal_.low, nominal_.high, share));
    }

    /// Derivatives of the energy by X: each is the derivative of the previous one by x over dX/dx (eq. 26, 27). The value is left out.
    [[nodiscard]] Jet at(double built) const {
        const double x = nominal_angle(built);
        const Jet c = cam_.deflection(x);
        const double s = c.value + longer_ * (x - nominal_.low) + preload_, s1 = c.first + longer_;
        const double x1 = 1.0 + wider_ * c.first, x2 = wider_ * c.second, x3 = wider_ * c.third;
        const double power1 = rate_ * (s1 * s1 + s * c.second),
                     power2 = rate_ * (3.0 * s1 * c.second + s * c.third);  // (k s s')', (k s s')''
        Jet u;
        u.first = rate_ * s * s1 / x1;
        const double force1 = (power1 - u.first * x2) / x1, force2 = (power2 - 2.0 * force1 * x2 - u.first * x3) / x1;
        u.second = force1 / x1;
        u.third = (force2 - u.second * x2) / (x1 * x1);
        return u;
    }

    NominalCam cam_;
    double rate_, preload_, wider_, longer_;
    core::Range nominal_, domain_;
};

/// @throws InvalidInput unless every arm of the nominal cam stays above 0 with `change` [m] added
void require_arms(const NominalCam& cam, BaseKind kind, double capstan_radius, double change) {
    constexpr int kPlaces = 64;
    for (int i = 0; i <= kPlaces; ++i) {
        const double x = std::lerp(cam.domain().low, cam.domain().high, static_cast<double>(i) / kPlaces), turn = cam.turned(x).slope;
        const double arm = kind == BaseKind::kTorsion ? capstan_radius / turn : turn;
        if (!(arm + change > 0.0))
            throw core::InvalidInput("build_error.radius", fmt::format("{:g} m", change),
                                     fmt::format("above {:g} m: the arm at {:.4g} rad must stay above 0", -arm, x));
    }
}

}  // namespace

PotentialPtr make_built_spring(PotentialPtr nominal, const BaseSpring& base, double capstan_radius, const BuildError& error) {
    core::require_positive("spring.rate", base.rate);
    core::require_positive("spring.preload", base.preload);
    core::require_positive("rig.capstan_radius", capstan_radius, "m");
    const double rate = base.rate * core::require_positive("build_error.rate + 1", 1.0 + error.rate);
    const double preload = core::require_positive("spring.preload + build_error.preload", base.preload + error.preload);
    const NominalCam cam(std::move(nominal), base);
    require_arms(cam, base.kind, capstan_radius, error.radius);
    if (base.kind == BaseKind::kTorsion) return std::make_shared<BuiltSpring>(cam, rate, preload, error.radius / capstan_radius, 0.0);
    return std::make_shared<BuiltSpring>(cam, rate, preload, 0.0, error.radius);
}

// rate/2 (state^2 - preload^2) = energy
double BaseSpring::state(double energy) const { return std::sqrt(preload * preload + 2.0 * energy / rate); }
math::Jet BaseSpring::state(const math::Jet& energy) const { return sqrt(preload * preload + 2.0 * energy / rate); }

BaseSpring in_series_with_cable(BaseSpring base, double compliance) {
    const double longer = 1.0 + base.rate * compliance;  // exactly 1 for compliance 0
    base.rate /= longer;
    base.preload *= longer;
    return base;
}

}  // namespace fusee::spring
