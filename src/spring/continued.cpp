#include <algorithm>
#include <utility>

#include "fusee/spring/potential.h"

namespace fusee::spring {

namespace {

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

PotentialPtr continued(PotentialPtr spring, double share) { return std::make_shared<Continued>(std::move(spring), share); }

}  // namespace fusee::spring
