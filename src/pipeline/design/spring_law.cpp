#include <variant>

#include "fusee/core/units.h"
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
