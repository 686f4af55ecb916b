#include <fmt/format.h>

#include <limits>
#include <type_traits>
#include <variant>

#include "fusee/actuator/dead_band.h"
#include "fusee/pipeline/design.h"
#include "fusee/spring/lead_in.h"

namespace fusee::pipeline {

namespace {

core::Outcome<spring::SpringLawPtr> bare_law(const profile::LawSpec& spec) {
    return std::visit(
        [&](const auto& curves) -> core::Outcome<spring::SpringLawPtr> {
            using Curves = std::decay_t<decltype(curves)>;
            if constexpr (std::is_same_v<Curves, spring::StictionLawOptions>) {
                return spring::make_stiction_law(curves);
            } else {
                spring::PotentialPtr series, parallel;
                if constexpr (std::is_same_v<Curves, profile::PolynomialPair>) {
                    series = spring::make_polynomial(curves.series);
                    parallel = spring::make_polynomial(curves.parallel);
                } else if constexpr (std::is_same_v<Curves, profile::ExponentialPair>) {
                    series = spring::make_exponential(curves.series.scale, curves.series.rate, curves.series.offset);
                    parallel = spring::make_exponential(curves.parallel.scale, curves.parallel.rate, curves.parallel.offset);
                } else {
                    series = spring::make_tabulated(curves.angle, curves.series, curves.smoothing);
                    parallel = spring::make_tabulated(curves.angle, curves.parallel, curves.smoothing);
                }
                return spring::make_pair_law(series, parallel, spec.start_torque, spec.end_torque);
            }
        },
        spec.curves);
}

/// The co-contraction nearest to `wanted` whose dead-band the springs cover, looking from the torque in the middle of the law's loads.
double covered_torque(const actuator::Actuator& joint, double wanted) {
    const auto covered = [&](double tau) { return actuator::dead_band(joint, tau).covered; };
    if (covered(wanted)) return wanted;
    double inside = 0.5 * (joint.law->loads().low + joint.law->loads().high), outside = wanted;
    if (!covered(inside)) return std::numeric_limits<double>::quiet_NaN();
    for (int i = 0; i < 40; ++i) (covered(0.5 * (inside + outside)) ? inside : outside) = 0.5 * (inside + outside);
    return inside;
}

core::Finding covers(const actuator::Actuator& joint, const char* side, double torque, core::Bound bound) {
    const bool low = bound == core::Bound::kAtMost;
    core::Finding f;
    f.rule = low ? "law.covers_least" : "law.covers_greatest";
    f.what = fmt::format("the springs must reach every resting place that stiction allows at the {} co-contraction", side);
    f.measured = covered_torque(joint, torque);
    f.bound = bound;
    f.allowed = torque;
    f.unit = "Nm";
    f.where = "law";
    const core::Range loads = joint.law->loads();
    // How far a law has to reach grows about as the torque does.
    f.suggestion = low ? fmt::format("rig.least_torque_Nm = {:.3g}, or law.lead_in_deg larger", 1.005 * f.measured)
                       : fmt::format("law.end_torque_Nm = {:.3g}, or rig.overdrive_torque_Nm = {:.3g}",
                                     1.01 * loads.high * torque / f.measured, 0.995 * f.measured);
    f.source = "a capstan at motor torque tau rests at loads from tau/(1+mu) to tau/(1-mu) (docs/theory/dead_band.md)";
    return core::judged(f, core::Severity::kReview);
}

}  // namespace

actuator::Actuator actuator_of(const profile::Profile& profile, const spring::SpringLawPtr& law) {
    const profile::Rig& rig = profile.rig;
    actuator::Actuator joint{
        law, rig.capstan_radius, rig.joint_radius, rig.gear_friction, rig.least_torque, rig.peak_torque, rig.overdrive_torque};
    actuator::validate(joint);
    return joint;
}

core::Outcome<DesignedLaw> design_law(const profile::Profile& profile) {
    const auto bare = bare_law(profile.law);
    if (!bare) return bare.refusal();
    if (core::Findings broken = spring::check_law(**bare); core::any_required(broken)) return broken;
    const auto law = spring::with_lead_in(*bare, profile.law.lead_in_travel);
    if (!law) return law.refusal();
    if (core::Findings broken = spring::check_law(**law); core::any_required(broken)) return broken;

    const actuator::Actuator joint = actuator_of(profile, *law);
    return DesignedLaw{*law,
                       (*bare)->loads(),
                       {covers(joint, "least", joint.least_torque, core::Bound::kAtMost),
                        covers(joint, "greatest", joint.overdrive_torque, core::Bound::kAtLeast)}};
}

}  // namespace fusee::pipeline
