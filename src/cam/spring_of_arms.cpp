#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "fusee/cam/arm.h"
#include "fusee/core/error.h"
#include "fusee/math/curve.h"

namespace fusee::cam {

namespace {

/// The quintic interpolant of rows, and its integral from the first row.
class Through {
public:
    Through(std::vector<double> x, const std::vector<double>& y) : curve_(math::make_interpolant(x, y)), x_(std::move(x)), sums_{0.0} {
        for (std::size_t i = 0; i + 1 < x_.size(); ++i) sums_.push_back(sums_.back() + between(x_[i], x_[i + 1]));
    }

    [[nodiscard]] const math::Curve& curve() const { return *curve_; }
    [[nodiscard]] const std::vector<double>& sums() const { return sums_; }  ///< the integral up to each row
    [[nodiscard]] double integral(double x) const {
        const double at = std::clamp(x, x_.front(), x_.back());
        const auto i = static_cast<std::size_t>(std::upper_bound(x_.begin() + 1, x_.end() - 1, at) - x_.begin()) - 1;
        return sums_[i] + between(x_[i], at);
    }

private:
    /// Gauss-Legendre with three points: exact for the quintic between two rows.
    [[nodiscard]] double between(double low, double high) const {
        const double middle = 0.5 * (low + high), half = 0.5 * (high - low), reach = std::sqrt(0.6) * half;
        return half / 9.0 * (5.0 * (curve_->value(middle - reach) + curve_->value(middle + reach)) + 8.0 * curve_->value(middle));
    }

    math::CurvePtr curve_;
    std::vector<double> x_, sums_;
};

class SpringOfArms final : public spring::Potential {
public:
    SpringOfArms(std::vector<double> travel, const std::vector<double>& torque) : torque_(std::move(travel), torque) {}

    [[nodiscard]] core::Range domain() const override { return torque_.curve().domain(); }
    [[nodiscard]] double energy(double x) const override { return torque_.integral(x); }
    [[nodiscard]] double force(double x) const override { return torque_.curve().value(x); }
    [[nodiscard]] double stiffness(double x) const override { return torque_.curve().derivative(x, 1); }
    [[nodiscard]] double slope(double x) const override { return torque_.curve().derivative(x, 2); }

private:
    Through torque_;
};

}  // namespace

spring::PotentialPtr spring_of_arms(PartKind kind, std::span<const FoundArm> arms, const spring::BaseSpring& base, double capstan_radius,
                                    const Allowance& allowance) {
    std::vector<double> angle, arm, travel, torque;
    for (const FoundArm& row : arms) {
        angle.push_back(row.angle);
        arm.push_back(row.arm + allowance.on_arms());
        if (!(arm.back() > 0.0))
            throw core::InvalidInput(fmt::format("arms[{}]", arm.size() - 1), fmt::format("{:g} m", row.arm), "above 0");
    }
    math::require_table(angle, arm, 4, "angle", "arms");
    const Through cable(angle, arm);  // its integral is the length of moved cable
    const spring::BaseSpring pulled = spring::in_series_with_cable(base, allowance.cable_compliance);
    const double behind_spool = allowance.behind_spool(capstan_radius);
    for (std::size_t i = 0; i < arm.size(); ++i) {
        const double moved = cable.sums()[i];
        if (kind == PartKind::kSeries) {
            const double tension = base.rate * (base.preload + angle[i] - angle[0]) / arm[i];
            torque.push_back(capstan_radius * tension);
            travel.push_back(moved / capstan_radius + behind_spool * (torque[i] - torque[0]));
        } else {
            torque.push_back(pulled.rate * (pulled.preload + moved) * arm[i]);
            travel.push_back(angle[i] - angle[0]);
        }
    }
    return std::make_shared<SpringOfArms>(std::move(travel), torque);
}

}  // namespace fusee::cam
