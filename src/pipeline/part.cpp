#include <fmt/format.h>

#include <string>

#include "compensated.h"
#include "fusee/cam/arm.h"
#include "fusee/checks/check.h"
#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "fusee/exchange/dxf.h"
#include "fusee/pipeline/design.h"

namespace fusee::pipeline {

namespace {

/// A helix that meets itself mostly does so between neighbouring turns of very different arms. How much steeper it has to climb for them to
/// part nothing but its solid tells: the first climb that makes one is the suggestion.
void suggest_climb(core::Finding& refusal, cam::PartKind kind, profile::Profile profile, const spring::SpringLawPtr& law) {
    const profile::PartSpec& spec = spec_of(kind, profile);
    if (spec.cam.path.kind != cam::PathKind::kHelix) return;
    cam::CamOptions& options = (kind == cam::PartKind::kSeries ? profile.k_se : profile.k_pe).cam;
    const bool aimed = options.path.lead == cam::Lead::kAimedAtGuide;
    double& climb = aimed ? options.guide.z : options.path.pitch;
    const double climb_mm = core::mm_from_m(climb);
    for (const double steeper : {1.1, 1.25, 1.5, 2.0, 3.0, 4.0}) {
        const std::string tried = fmt::format("{:.2f}", steeper * climb_mm);
        climb = core::m_from_mm(std::stod(tried));
        const auto cam = design_cam(kind, profile, law);
        if (!cam || !solid::build_part(*cam, spec.solid)) continue;
        refusal.suggestion = fmt::format("{}.{} = {}", to_string(kind), aimed ? "guide.z_mm" : "path.pitch_mm", tried);
        return;
    }
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
    const profile::PartSpec& spec = spec_of(kind, profile);
    const cam::ArmFunction arm(kind, law, spec.spring, profile.rig.capstan_radius, spec.allowance);
    return cam::synthesize_cam(arm, spec.cam);
}

core::Outcome<DesignedPart> design_part(cam::PartKind kind, const profile::Profile& profile, const spring::SpringLawPtr& law) {
    const profile::PartSpec& spec = spec_of(kind, profile);
    const auto cam = design_cam(kind, profile, law);
    if (!cam) return cam.refusal();
    auto part = solid::build_part(*cam, spec.solid);
    if (!part) {
        core::Findings refusal = part.refusal();
        for (core::Finding& f : refusal)
            if (f.rule == "solid.validity") suggest_climb(f, kind, profile, law);
        return refusal;
    }
    core::Findings findings = checks::check({*part, spec.spring, profile.cable, profile.process, profile.limits});
    core::append(findings, check_cable_length(*cam, profile));
    if (!core::any_required(findings)) core::append(findings, check_compensated(*part, profile, findings));
    if (core::any_required(findings)) return findings;
    return DesignedPart{std::move(part).value(), std::move(findings)};
}

}  // namespace fusee::pipeline
