#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "compensated.h"
#include "fusee/cam/arm.h"
#include "fusee/checks/check.h"
#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "fusee/exchange/dxf.h"
#include "fusee/pipeline/design.h"

namespace fusee::pipeline {

namespace {

cam::ArmFunction arm_of(cam::PartKind kind, const profile::Profile& profile, const spring::SpringLawPtr& law) {
    const profile::PartSpec& spec = spec_of(kind, profile);
    return {kind, law, spec.spring, profile.rig.capstan_radius, spec.allowance};
}

/// A change of a path, and how a profile says it.
struct Climb {
    cam::CamOptions options;
    std::string change;
};

/// Steeper and steeper ones. A groove that climbs to its guide also has the way of no longer doing so.
std::vector<Climb> steeper(const std::string& part, const cam::CamOptions& from) {
    const bool aimed = from.path.lead == cam::Lead::kAimedAtGuide;
    std::vector<Climb> climbs;
    for (const double share : {1.1, 1.25, 1.5, 2.0, 3.0, 4.0}) {
        cam::CamOptions to = from;
        double& climb = aimed ? to.guide.z : to.path.pitch;
        const std::string mm = fmt::format("{:.2f}", share * core::mm_from_m(climb));
        climb = core::m_from_mm(std::stod(mm));
        climbs.push_back({to, fmt::format("{}.{} = {}", part, aimed ? "guide.z_mm" : "path.pitch_mm", mm)});
    }
    for (const double cables : {4.0, 6.0, 10.0, 16.0}) {
        if (!aimed) break;
        cam::CamOptions to = from;
        const std::string mm = fmt::format("{:.2f}", cables * core::mm_from_m(from.cable_diameter));
        to.path.lead = cam::Lead::kConstantPitch;
        to.path.pitch = core::m_from_mm(std::stod(mm));
        climbs.push_back({to, fmt::format("{0}.path.lead = \"constant_pitch\" with {0}.path.pitch_mm = {1}", part, mm)});
    }
    return climbs;
}

/// A helix that meets itself mostly does so between neighbouring turns of very different arms. How steep it has to climb for them to part
/// nothing but its solid tells: the first climb that makes one is the suggestion.
void suggest_climb(core::Finding& refusal, const cam::ArmFunction& arm, const profile::PartSpec& spec) {
    if (spec.cam.path.kind != cam::PathKind::kHelix) return;
    const std::string part = to_string(arm.kind());
    const std::vector<Climb> climbs = steeper(part, spec.cam);
    const auto found = std::find_if(climbs.begin(), climbs.end(), [&](const Climb& climb) {
        const auto cam = cam::synthesize_cam(arm, climb.options);
        return cam && solid::build_part(*cam, spec.solid);
    });
    refusal.suggestion = found != climbs.end() ? found->change
                                               : fmt::format("a base spring of {} whose arms differ less: even {} leaves its faces meeting",
                                                             part, climbs.back().change);
}

}  // namespace

void require_parts(const profile::Profile& profile) {
    if (profile.rig.arrangement != actuator::Arrangement::kPnrvsa)
        throw core::InvalidInput("rig.arrangement", to_string(profile.rig.arrangement),
                                 "\"pnrvsa\" to make parts; the others can be simulated");
    if (!profile.has_parts)
        throw core::InvalidInput(
            "k_se.spring.rate_Nm_per_rad", "missing",
            "[cable], [process], [k_se.spring] and [k_pe.spring] to make parts; without them a profile can be simulated");
    if (profile.outputs.dxf && profile.outputs.kerf > 0.0)
        for (const profile::PartSpec* spec : {&profile.k_se, &profile.k_pe})
            exchange::require_kerf(core::mm_from_m(profile.outputs.kerf), spec->solid.hub);
}

const profile::PartSpec& spec_of(cam::PartKind kind, const profile::Profile& profile) {
    return kind == cam::PartKind::kSeries ? profile.k_se : profile.k_pe;
}

core::Outcome<cam::Cam> design_cam(cam::PartKind kind, const profile::Profile& profile, const spring::SpringLawPtr& law) {
    return cam::synthesize_cam(arm_of(kind, profile, law), spec_of(kind, profile).cam);
}

core::Outcome<DesignedPart> design_part(cam::PartKind kind, const profile::Profile& profile, const spring::SpringLawPtr& law) {
    const profile::PartSpec& spec = spec_of(kind, profile);
    const auto cam = design_cam(kind, profile, law);
    if (!cam) return cam.refusal();
    auto part = solid::build_part(*cam, spec.solid);
    if (!part) {
        core::Findings refusal = part.refusal();
        for (core::Finding& f : refusal)
            if (f.rule == "solid.validity") suggest_climb(f, arm_of(kind, profile, law), spec);
        return refusal;
    }
    core::Findings findings = checks::check({*part, spec.spring, profile.cable, profile.process, profile.limits});
    core::append(findings, check_cable_length(*cam, profile));
    if (!core::any_error(findings)) core::append(findings, check_compensated(*part, profile, findings));
    if (core::any_error(findings)) return findings;
    return DesignedPart{std::move(part).value(), std::move(findings)};
}

}  // namespace fusee::pipeline
