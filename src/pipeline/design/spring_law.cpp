#include <cmath>
#include <functional>
#include <memory>
#include <variant>

#include "fusee/core/units.h"
#include "fusee/math/chebyshev.h"
#include "fusee/math/curve.h"
#include "fusee/pipeline/design.h"
#include "fusee/spring/laws.h"

namespace fusee::pipeline {

namespace {

/// A curve in SI over the law's loads; a formula's values are multiplied by `unit`.
math::CurvePtr curve_of(const char* key, const profile::TorqueCurve& given, core::Range torques, double unit) {
    if (!given.rows.file.empty()) return math::make_interpolant(given.rows.x, given.rows.y);
    if (given.formula.empty()) return {};
    return math::make_scaled(math::make_formula(key, given.formula, "tau", torques), unit);
}

/// The torque of a formula of its stiffness: the first one and the integral.
std::function<double(double)> integral_of(const profile::OneSpring& one) {
    const math::CurvePtr stiffness = math::make_formula("law.stiffness_Nm_per_rad", one.formula, "x", one.angles);
    const auto pieces = std::make_shared<const math::PiecewiseChebyshev>([stiffness](double x) { return stiffness->value(x); }, one.angles);
    return [pieces, first = one.torque](double x) { return first + pieces->integral(x); };
}

/// The spring of a profile of kind "spring".
spring::PotentialPtr one_spring(const profile::OneSpring& one) {
    using Kind = profile::OneSpring::Kind;
    const auto of = [&](const char* key, const std::function<double(double)>& torque) {
        return spring::make_of_torque(key, torque, one.angles);
    };
    constexpr double kGravity = 9.80665;  // [m/s^2]
    switch (one.kind) {
        case Kind::kConstant:
            return of("law.torque_Nm", [&](double) { return one.torque; });
        case Kind::kGravity:
            return of("law.mass_kg", [&](double x) { return one.mass * kGravity * one.lever * std::sin(x); });
        case Kind::kPolynomial:
            return of("law.coefficients_Nm", [spring = spring::make_polynomial(one.coefficients)](double x) { return spring->force(x); });
        case Kind::kExponential: {
            const auto& [scale, rate, offset] = one.exponential;
            return of("law.scale_Nm", [spring = spring::make_exponential(scale, rate, offset)](double x) { return spring->force(x); });
        }
        case Kind::kStiffness:
            return of("law.stiffness_Nm_per_rad", integral_of(one));
        case Kind::kFormula:
            return of("law.formula_Nm",
                      [curve = math::make_formula("law.formula_Nm", one.formula, "x", one.angles)](double x) { return curve->value(x); });
        case Kind::kPoints: {
            const math::CurvePtr curve = math::make_interpolant(one.rows.x, one.rows.y);
            return spring::make_of_torque(
                "law.torques_Nm", [curve](double x) { return curve->value(x); }, curve->domain());
        }
        case Kind::kTable:
            break;
    }
    return spring::make_tabulated(one.rows.x, one.rows.y, one.smoothing);
}

/// What one of two taut cables pulls with: their difference is the law, and neither is below the least torque (docs/theory/cams.md, eq.
/// 23).
spring::PotentialPtr one_way(const spring::PotentialPtr& whole, const profile::OneSpring& one) {
    if (one.two_cables.way == profile::OneSpring::TwoCables::Way::kBoth) return whole;
    const double sign = one.pulls_back() ? -1.0 : 1.0;
    const core::Range angles = whole->domain();
    return spring::make_of_torque(
        "cam.least_torque_Nm", [whole, sign, two = one.two_cables](double x) { return two.pull(sign * whole->force(sign * x)); },
        sign > 0.0 ? angles : core::Range{-angles.high, -angles.low});
}

/// One maker for each kind of curves.
class Maker {
public:
    using Made = core::Outcome<spring::SpringLawPtr>;
    explicit Maker(const profile::Profile& profile) : profile_(profile), law_(profile.law) {}

    Made operator()(const spring::StictionLawOptions& o) const {
        const spring::FrictionLaw friction = gear_friction(profile_);
        if (friction.is_proportional()) return spring::make_stiction_law(o);  // closed in tau
        return spring::make_general_stiction_law({o.k, o.u, o.c, friction, o.start_torque, o.end_torque});
    }
    Made operator()(const profile::PolynomialPair& pair) const {
        return paired(spring::make_polynomial(pair.series), spring::make_polynomial(pair.parallel));
    }
    Made operator()(const profile::ExponentialPair& pair) const {
        const auto& [series, parallel] = pair;
        return paired(spring::make_exponential(series.scale, series.rate, series.offset),
                      spring::make_exponential(parallel.scale, parallel.rate, parallel.offset));
    }
    Made operator()(const profile::TablePair& pair) const {
        return paired(spring::make_tabulated(pair.angle, pair.series, pair.smoothing),
                      spring::make_tabulated(pair.angle, pair.parallel, pair.smoothing));
    }
    Made operator()(const profile::DeadBandSpec& wanted) const {
        const core::Range torques{law_.start_torque, law_.end_torque};
        return spring::make_dead_band_law(
            {.dead_band = curve_of("law.dead_band_deg", wanted.dead_band, torques, core::rad_from_deg(1.0)),
             .series_stiffness = curve_of("law.series_stiffness_Nm_per_rad", wanted.series_stiffness, torques, 1.0),
             .start_transmission = wanted.start_transmission,
             .friction = gear_friction(profile_),
             .ratio = profile_.rig.joint_radius / profile_.rig.capstan_radius,
             .start_torque = torques.low,
             .end_torque = torques.high});
    }
    Made operator()(const spring::FreeCurveOptions& knots) const { return spring::make_free_curve(knots); }

    Made operator()(const profile::OneSpring& one) const { return spring::make_one_spring_law(one_way(one_spring(one), one)); }

private:
    [[nodiscard]] Made paired(spring::PotentialPtr series, spring::PotentialPtr parallel) const {
        return spring::make_pair_law(std::move(series), std::move(parallel), law_.start_torque, law_.end_torque);
    }
    const profile::Profile& profile_;
    const profile::LawSpec& law_;
};

}  // namespace

spring::FrictionLaw gear_friction(const profile::Profile& profile) {
    const profile::Rig& rig = profile.rig;
    if (!rig.gear_friction_table.file.empty())
        return spring::FrictionLaw::tabulated(rig.gear_friction_table.x, rig.gear_friction_table.y, rig.gear_friction_rest_excess);
    if (rig.gear_friction_constant == 0.0 && rig.gear_friction_rest_excess == 0.0)
        return spring::FrictionLaw::proportional(rig.gear_friction);
    return spring::FrictionLaw::affine(rig.gear_friction_constant, rig.gear_friction, rig.gear_friction_rest_excess);
}

core::Outcome<spring::SpringLawPtr> spring_law(const profile::Profile& profile) { return std::visit(Maker(profile), profile.law.curves); }

}  // namespace fusee::pipeline
