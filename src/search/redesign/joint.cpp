#include "joint.h"

#include <algorithm>
#include <cmath>

#include "fusee/actuator/dead_band.h"
#include "fusee/actuator/stick_slip.h"
#include "fusee/pipeline/design.h"
#include "fusee/spring/potential.h"

namespace fusee::search::redesign {

namespace {

spring::BuildError departure_of_part(const profile::PartSpec& cut_for, const profile::PartSpec& as_is) {
    const spring::BaseSpring drawn = pipeline::pulled_spring(cut_for), is = pipeline::pulled_spring(as_is);
    return {is.rate / drawn.rate - 1.0, as_is.allowance.radius - cut_for.allowance.radius, is.preload - drawn.preload};
}

double torque_error(const spring::Potential& built, const spring::Potential& law) {
    constexpr int kPlaces = 200;
    const double end = std::min(built.domain().high, law.domain().high);
    double worst = 0.0;
    for (int i = 0; i <= kPlaces; ++i) {
        const double x = end * i / kPlaces;
        worst = std::max(worst, std::abs(built.force(x) / law.force(x) - 1.0));
    }
    return worst;
}

}  // namespace

spring::PotentialPtr series_as_built(const Cams& cams, const profile::Profile& as_is) {
    const profile::PartSpec& cut_for = cams.profile->k_se;
    const double radius = as_is.rig.capstan_radius;
    const spring::PotentialPtr spool =
        spring::with_compliance(spring::resampled(spring::series_spring(cams.law)), -cut_for.allowance.behind_spool(radius));
    const spring::PotentialPtr built = spring::make_built_spring(spool, cut_for.spring, radius, departure_of_part(cut_for, as_is.k_se));
    return spring::resampled(spring::with_compliance(built, as_is.k_se.allowance.behind_spool(radius)));
}

spring::PotentialPtr parallel_as_built(const Cams& cams, const profile::Profile& as_is) {
    const profile::PartSpec& cut_for = cams.profile->k_pe;
    return spring::resampled(spring::make_built_spring(spring::resampled(spring::parallel_spring(cams.law)),
                                                       pipeline::pulled_spring(cut_for), as_is.rig.capstan_radius,
                                                       departure_of_part(cut_for, as_is.k_pe)));
}

actuator::Joint joint_as_built(const std::array<Cams, 2>& cams, const std::array<profile::Profile, 2>& as_is) {
    const profile::Rig& rig = as_is[0].rig;
    actuator::Joint joint =
        actuator::antagonist(parallel_as_built(cams[0], as_is[0]), series_as_built(cams[0], as_is[0]), series_as_built(cams[1], as_is[1]),
                             parallel_as_built(cams[1], as_is[1]), {pipeline::gear_friction(as_is[0]), pipeline::gear_friction(as_is[1])},
                             rig.capstan_radius, rig.joint_radius);
    joint.output_friction = rig.joint_friction;
    return joint;
}

double torque_error(const std::array<Cams, 2>& cams, const std::array<profile::Profile, 2>& as_is) {
    double worst = 0.0;
    for (const int side : {0, 1}) {
        worst = std::max(worst, torque_error(*series_as_built(cams[side], as_is[side]), *spring::series_spring(cams[side].law)));
        worst = std::max(worst, torque_error(*parallel_as_built(cams[side], as_is[side]), *spring::parallel_spring(cams[side].law)));
    }
    return worst;
}

DeadBandWidths dead_band_widths(const actuator::Joint& joint, double tau, double push_torque) {
    return {actuator::joint_dead_band(joint, tau, tau).exact_width,
            actuator::release_test(joint, tau, {.push_torque = push_torque, .find_full_push = false}).width()};
}

}  // namespace fusee::search::redesign
