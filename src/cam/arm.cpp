#include "fusee/cam/arm.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "enclosure.h"
#include "fusee/core/error.h"
#include "fusee/math/curve.h"

namespace fusee::cam {

namespace {

/// 1/S must be above the compliance; otherwise the spool would have to be stiffer than rigid.
void require_softer(const spring::SpringLaw& law, double compliance, const char* key) {
    constexpr int kPlaces = 200;
    if (compliance == 0.0) return;
    const core::Range loads = law.loads();
    double stiffest = 0.0;
    for (int i = 0; i <= kPlaces; ++i) stiffest = std::max(stiffest, law.at_load(loads.low + loads.width() * i / kPlaces).s);
    if (compliance * stiffest >= 1.0)
        throw core::InvalidInput(key, fmt::format("{:.4g} rad/Nm at the capstan", compliance),
                                 fmt::format("below {:.4g} rad/Nm = 1/S at the law's stiffest point: a stiffer or shorter cable, or a "
                                             "softer law",
                                             1.0 / stiffest));
}

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

const char* to_string(PartKind kind) { return kind == PartKind::kSeries ? "k_se" : "k_pe"; }

ArmFunction::ArmFunction(PartKind kind, spring::SpringLawPtr law, spring::BaseSpring base, double capstan_radius,
                         const Allowance& allowance)
    : kind_(kind), law_(std::move(law)), base_(base), capstan_radius_(capstan_radius), allowance_(allowance) {
    const auto wanted = kind == PartKind::kSeries ? spring::BaseKind::kTorsion : spring::BaseKind::kCompression;
    const std::string part = to_string(kind);
    if (base_.kind != wanted)
        throw core::InvalidInput(part + ".spring", "wrong kind", kind == PartKind::kSeries ? "a torsion spring" : "a compression spring");
    core::require_positive(part + ".spring.rate", base_.rate);
    core::require_within(part + ".spring.preload", base_.preload, 0.0, 1e6);
    core::require_positive("rig.capstan_radius", capstan_radius_, "m");
    core::require_within(part + ".radius_allowance", allowance_.radius, -1.0, 1.0, "m");
    core::require_within("compensation.cable_axis", allowance_.cable_axis, -1.0, 1.0, "m");
    core::require_within("compensation." + part + "_contour", allowance_.contour, -1.0, 1.0, "m");
    core::require_within(part + ".cable_compliance", allowance_.cable_compliance, 0.0, 1.0, "m/N");
    pulled_ = spring::in_series_with_cable(base_, allowance_.cable_compliance);
    if (kind_ != PartKind::kSeries) return;
    core::require_within("k_se.cable_compliance_rad_per_Nm", allowance_.series_compliance, 0.0, 1e6, "rad/Nm");
    behind_spool_ = allowance_.behind_spool(capstan_radius_);
    require_softer(*law_, behind_spool_, allowance_.cable_compliance > 0.0 ? "k_se.cable_length_mm" : "k_se.cable_compliance_rad_per_Nm");
    least_series_torque_ = law_->at_load(law_->loads().low).f_se;
}

ArmFunction ArmFunction::on(const spring::BaseSpring& base) const { return {kind_, law_, base, capstan_radius_, allowance_}; }

/// The law's point without the cable's share of K_SE: same torque, with the spool's own stiffness and energy.
template <class Point>
Point ArmFunction::behind_cable(Point p) const {
    const double c = behind_spool_;
    if (c == 0.0) return p;
    const auto share = 1.0 - c * p.s;  // the spool's share of the deflection
    p.u_se -= 0.5 * c * (p.f_se * p.f_se - least_series_torque_ * least_series_torque_);
    p.s_slope /= share * share * share;
    p.s /= share;
    return p;
}

// docs/theory/cams.md, table 1. Primes are by the cam's own angle: phi for the spool, theta for the cam.
template <class Arm, class Point>
Arm ArmFunction::arm_of(const Point& law) const {
    const Point p = behind_cable(law);
    Arm a;
    a.tau = p.tau;
    if (kind_ == PartKind::kSeries) {
        const auto force = p.f_se / capstan_radius_;                                          // U' of the cable [N]
        const auto rate = p.s / (capstan_radius_ * capstan_radius_);                          // U'' [N/m]
        const auto rise = p.s_slope / (capstan_radius_ * capstan_radius_ * capstan_radius_);  // U''' [N/m^2]
        a.state = base_.state(p.u_se);
        a.angle = a.state - base_.preload;
        a.arm = base_.rate * a.state / force;
        a.slope = (base_.rate - rate * a.arm * a.arm) / force;
        a.second_derivative = -a.arm * (rise * a.arm * a.arm + 3.0 * rate * a.slope) / force;
        a.tension = force;
    } else {
        const auto drawn = pulled_.state(p.u_pe);  // y + y0 and the cable elongation
        a.state = allowance_.cable_compliance == 0.0 ? drawn : pulled_.rate * drawn / base_.rate;
        a.angle = p.theta;
        a.tension = pulled_.rate * drawn;
        a.arm = p.f_pe / a.tension;
        a.slope = (p.p - pulled_.rate * a.arm * a.arm) / a.tension;
        a.second_derivative = (p.p_slope - 3.0 * pulled_.rate * a.arm * a.slope) / a.tension;
    }
    a.travel = a.state - base_.preload;
    a.arm -= allowance_.on_arms();
    if (fleet_correction_) fleet_correction_->project_to_plane(a);
    return a;
}

ArmFunction ArmFunction::corrected_for_fleet_angle(const FleetAngleCorrection& correction) const {
    ArmFunction other = *this;
    other.fleet_correction_ = correction;
    return other;
}

// docs/theory/cams.md, eq. 22. K_PE: spring and cable share each piece of drawn cable in the same proportion.
CableElongation ArmFunction::elongation(const spring::LawPoint& law, double tension) const {
    if (kind_ == PartKind::kSeries) {
        const double turn = behind_spool_ * (law.f_se - least_series_torque_);
        return {capstan_radius_ * turn, turn, law.theta};
    }
    const double of_cable = allowance_.cable_compliance * pulled_.rate;
    return {allowance_.cable_compliance * (tension - base_.rate * base_.preload), of_cable * law.theta, law.theta};
}

ArmPoint ArmFunction::at_load(double tau) const {
    const spring::LawPoint law = law_->at_load(tau);
    ArmPoint a = arm_of<ArmPoint>(law);
    a.tau = tau;
    a.elongation = elongation(law, a.tension);
    return a;
}

ArmJet ArmFunction::over(const spring::LawJet& law) const { return arm_of<ArmJet>(law); }

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
