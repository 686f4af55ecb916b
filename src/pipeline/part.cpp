#include "fusee/cam/arm.h"
#include "fusee/checks/check.h"
#include "fusee/core/error.h"
#include "fusee/pipeline/design.h"

namespace fusee::pipeline {

void require_parts(const profile::Profile& profile) {
    if (profile.rig.arrangement != actuator::Arrangement::kPnrvsa)
        throw core::InvalidInput("rig.arrangement", to_string(profile.rig.arrangement),
                                 "\"pnrvsa\" to make parts; the others can be simulated");
    if (!profile.has_parts)
        throw core::InvalidInput(
            "k_se.spring.rate_Nm_per_rad", "missing",
            "[cable], [process], [k_se.spring] and [k_pe.spring] to make parts; without them a profile can be simulated");
}

core::Outcome<DesignedPart> design_part(cam::PartKind kind, const profile::Profile& profile, const spring::SpringLawPtr& law) {
    const profile::PartSpec& spec = kind == cam::PartKind::kSeries ? profile.k_se : profile.k_pe;
    const cam::ArmFunction arm(kind, law, spec.spring, profile.rig.capstan_radius, spec.allowance);
    const auto cam = cam::synthesize_cam(arm, spec.cam);
    if (!cam) return cam.refusal();
    auto part = solid::build_part(*cam, spec.solid);
    if (!part) return part.refusal();
    core::Findings findings = checks::check({*part, spec.spring, profile.cable, profile.process, profile.limits});
    if (core::any_required(findings)) return findings;
    return DesignedPart{std::move(part).value(), std::move(findings)};
}

}  // namespace fusee::pipeline
