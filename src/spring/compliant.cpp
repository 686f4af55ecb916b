#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "fusee/core/error.h"
#include "fusee/math/roots.h"
#include "fusee/spring/potential.h"

namespace fusee::spring {

namespace {

class Compliant final : public Potential {
public:
    Compliant(PotentialPtr spring, double compliance)
        : spring_(std::move(spring)), compliance_(compliance), own_(spring_->domain()), least_(spring_->force(own_.low)) {
        domain_ = {own_.low, own_.high + compliance_ * (spring_->force(own_.high) - least_)};
    }

    [[nodiscard]] core::Range domain() const override { return domain_; }
    /// The energy of spring and cable above that at the lower end.
    [[nodiscard]] double energy(double deflection) const override {
        const double x = own_deflection(deflection), force = spring_->force(x);
        return spring_->energy(x) + 0.5 * compliance_ * (force * force - least_ * least_);
    }
    [[nodiscard]] double force(double deflection) const override { return spring_->force(own_deflection(deflection)); }
    [[nodiscard]] double stiffness(double deflection) const override {
        const double own = spring_->stiffness(own_deflection(deflection));
        return own / (1.0 + compliance_ * own);
    }
    [[nodiscard]] double slope(double deflection) const override {
        const double x = own_deflection(deflection), share = 1.0 + compliance_ * spring_->stiffness(x);
        return spring_->slope(x) / (share * share * share);
    }

private:
    [[nodiscard]] double own_deflection(double deflection) const {
        const double wanted = std::clamp(deflection, domain_.low, domain_.high);
        const auto excess = [&](double x) {
            return math::Tangent{x + compliance_ * (spring_->force(x) - least_) - wanted, 1.0 + compliance_ * spring_->stiffness(x)};
        };
        const double share = (wanted - domain_.low) / domain_.width();
        return math::rising_root(excess, own_.low, own_.high, std::lerp(own_.low, own_.high, share));
    }

    PotentialPtr spring_;
    double compliance_;
    core::Range own_, domain_;
    double least_;
};

class Continued final : public Potential {
public:
    Continued(PotentialPtr inner, double share)
        : inner_(std::move(inner)), range_(inner_->domain()), beyond_(share * range_.width()), below_(beyond_) {
        constexpr double kAlmost = 0.999;        // of the way to a torque of 0
        const double slope = chord(range_.low);  // a cable cannot push
        if (slope > 0.0) below_ = std::clamp(kAlmost * inner_->force(range_.low) / slope, 0.0, beyond_);
    }

    [[nodiscard]] core::Range domain() const override { return {range_.low - below_, range_.high + beyond_}; }
    [[nodiscard]] double force(double x) const override { return inner_->force(held(x)) + chord(x) * (x - held(x)); }
    [[nodiscard]] double stiffness(double x) const override { return range_.holds(x) ? inner_->stiffness(x) : chord(x); }
    [[nodiscard]] double slope(double x) const override { return range_.holds(x) ? inner_->slope(x) : 0.0; }
    [[nodiscard]] double energy(double x) const override {
        return inner_->energy(held(x)) + 0.5 * (inner_->force(held(x)) + force(x)) * (x - held(x));
    }

private:
    [[nodiscard]] double held(double x) const { return std::clamp(x, range_.low, range_.high); }
    [[nodiscard]] double chord(double x) const {
        const double end = held(x), inside = x > range_.low ? end - beyond_ : end + beyond_;
        return (inner_->force(end) - inner_->force(inside)) / (end - inside);
    }

    PotentialPtr inner_;
    core::Range range_;
    double beyond_, below_;
};

}  // namespace

PotentialPtr with_compliance(PotentialPtr spring, double compliance) {
    if (compliance == 0.0) return spring;
    for (const double end : {spring->domain().low, spring->domain().high})
        if (!(1.0 + compliance * spring->stiffness(end) > 0.0))
            throw core::InvalidInput("compliance", fmt::format("{:g} rad/Nm", compliance), "1 + c S above 0");
    return std::make_shared<Compliant>(std::move(spring), compliance);
}

PotentialPtr continued(PotentialPtr spring, double share) { return std::make_shared<Continued>(std::move(spring), share); }

}  // namespace fusee::spring
