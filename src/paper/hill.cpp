#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "fusee/core/error.h"
#include "fusee/math/roots.h"
#include "fusee/paper/paper.h"

// Equation numbers: docs/theory/hill.md.
namespace fusee::paper {

namespace {

void validate_muscle(const LinearMuscle& muscle) {
    core::require_positive("k_se", muscle.k_se);
    core::require_within("k_pe", muscle.k_pe, 0.0, std::numeric_limits<double>::max());
}

/// Greatest torque of a joint's spring [Nm]: an exponential is infinite at the far end of its domain.
constexpr double kStrongest = 1e9;

/// Deflection of a rising spring at which it carries `force`.
double deflection(const spring::Potential& spring, double force) {
    const core::Range domain = spring.domain();
    const auto root =
        math::bracketed_root([&](double x) { return std::min(spring.force(x), 2.0 * kStrongest) - force; }, domain.low, domain.high);
    return root.value_or(spring.force(domain.low) >= force ? domain.low : domain.high);
}

/// Two springs in series, eq. 5 to 8.
class InSeries final : public spring::Potential {
public:
    InSeries(spring::PotentialPtr k_se, spring::PotentialPtr k_pe, core::Range forces)
        : k_se_(std::move(k_se)),
          k_pe_(std::move(k_pe)),
          l_{deflection(*k_pe_, forces.low), deflection(*k_pe_, forces.high)},
          domain_{deflection(*k_se_, forces.low) + l_.low, deflection(*k_se_, forces.high) + l_.high} {}

    [[nodiscard]] core::Range domain() const override { return domain_; }
    [[nodiscard]] double energy(double length) const override {
        const double l = share(length);
        return k_se_->energy(length - l) + k_pe_->energy(l);
    }
    [[nodiscard]] double force(double length) const override { return k_pe_->force(share(length)); }
    [[nodiscard]] double stiffness(double length) const override {
        const double l = share(length);
        const double se = k_se_->stiffness(length - l), pe = k_pe_->stiffness(l);
        return se * pe / (se + pe);
    }
    [[nodiscard]] double slope(double length) const override {
        const double l = share(length);
        const double se = k_se_->stiffness(length - l), pe = k_pe_->stiffness(l), sum = se + pe;
        return (k_se_->slope(length - l) * pe * pe * pe + k_pe_->slope(l) * se * se * se) / (sum * sum * sum);
    }

private:
    /// The stretch l of K_PE: F_PE(l) - F_SE(L - l) rises with l. Outside the domain it stays at the end.
    [[nodiscard]] double share(double length) const {
        const double at = std::clamp(length, domain_.low, domain_.high);
        const auto excess = [&](double l) {
            return std::min(k_pe_->force(l), 2.0 * kStrongest) - std::min(k_se_->force(at - l), 2.0 * kStrongest);
        };
        const core::Range se = k_se_->domain();
        const double low = std::max(l_.low, at - se.high), high = std::min(l_.high, at - se.low);
        return math::bracketed_root(excess, low, high).value_or(excess(low) >= 0.0 ? low : high);
    }

    spring::PotentialPtr k_se_, k_pe_;
    core::Range l_, domain_;  ///< stretch of K_PE, stretch of both
};

/// Checks by a scan that the stiffness is above 0, which makes the share unique.
void require_stiff(const char* field, const spring::PotentialPtr& spring) {
    if (!spring) throw core::InvalidInput(field, "none", "a spring");
    constexpr int kSteps = 200;
    const core::Range domain = spring->domain();
    for (int i = 1; i < kSteps; ++i) {
        const double x = domain.low + domain.width() * i / kSteps, stiffness = spring->stiffness(x);
        if (!(stiffness > 0.0))
            throw core::InvalidInput(field, fmt::format("stiffness {:.4g} Nm/rad at {:.4g} rad", stiffness, x), "above 0 throughout");
    }
}

}  // namespace

double series_contractile(const LinearMuscle& muscle, double length, double active) {
    validate_muscle(muscle);
    return (muscle.k_se * length - active) / (muscle.k_se + muscle.k_pe);  // eq. 1
}

double series_force(const LinearMuscle& muscle, double length, double active) {
    return muscle.k_se * (length - series_contractile(muscle, length, active));
}

double parallel_force(const LinearMuscle& muscle, double length, double contractile) {
    validate_muscle(muscle);
    return muscle.k_pe * length + muscle.k_se * (length - contractile);  // eq. 2
}

LinearMuscle parallel_from_series(const LinearMuscle& muscle) {
    validate_muscle(muscle);
    const double sum = muscle.k_se + muscle.k_pe;
    return {.k_se = muscle.k_se * muscle.k_se / sum, .k_pe = muscle.k_se * muscle.k_pe / sum};  // eq. 3
}

double contractile_from_active(const LinearMuscle& series, double length, double active) {
    validate_muscle(series);
    return length - active / series.k_se;  // eq. 4
}

spring::PotentialPtr passive_tension(spring::PotentialPtr k_se, spring::PotentialPtr k_pe) {
    require_stiff("k_se", k_se);
    require_stiff("k_pe", k_pe);
    const auto weakest = [](const spring::Potential& s) { return s.force(s.domain().low); };
    const auto strongest = [](const spring::Potential& s) { return s.force(s.domain().high); };
    const core::Range forces{std::max(weakest(*k_se), weakest(*k_pe)), std::min({strongest(*k_se), strongest(*k_pe), kStrongest})};
    if (!(forces.low < forces.high))
        throw core::InvalidInput("k_pe", fmt::format("{:.4g} to {:.4g} Nm", weakest(*k_pe), strongest(*k_pe)),
                                 fmt::format("torques in common with k_se, {:.4g} to {:.4g} Nm", weakest(*k_se), strongest(*k_se)));
    return std::make_shared<InSeries>(std::move(k_se), std::move(k_pe), forces);
}

}  // namespace fusee::paper
