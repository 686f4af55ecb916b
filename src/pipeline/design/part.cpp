#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "anchor.h"
#include "export/compensated.h"
#include "fusee/cam/arm.h"
#include "fusee/checks/check.h"
#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "fusee/drawing/inspection.h"
#include "fusee/exchange/dxf.h"
#include "fusee/pipeline/design.h"

namespace fusee::pipeline {

namespace {

/// A steeper path, and its key as a profile has it.
struct SteeperPath {
    cam::CamOptions options;
    std::string change;
};

/// By rising pitch. A groove aimed at its guide may also get a constant pitch.
std::vector<SteeperPath> steeper(const std::string& part, const cam::CamOptions& from) {
    const bool aimed = from.path.lead == cam::Lead::kAimedAtGuide;
    std::vector<SteeperPath> paths;
    for (const double share : {1.1, 1.25, 1.5, 2.0, 3.0, 4.0}) {
        cam::CamOptions to = from;
        double& rise = aimed ? to.guide.z : to.path.pitch;
        const std::string mm = fmt::format("{:.2f}", share * core::mm_from_m(rise));
        rise = core::m_from_mm(std::stod(mm));
        paths.push_back({to, fmt::format("{}.{} = {}", part, aimed ? "guide.z_mm" : "path.pitch_mm", mm)});
    }
    for (const double cables : {4.0, 6.0, 10.0, 16.0}) {
        if (!aimed) break;
        cam::CamOptions to = from;
        const std::string mm = fmt::format("{:.2f}", cables * core::mm_from_m(from.cable_diameter));
        to.path.lead = cam::Lead::kConstantPitch;
        to.path.pitch = core::m_from_mm(std::stod(mm));
        paths.push_back({to, fmt::format("{0}.path.lead = \"constant_pitch\" with {0}.path.pitch_mm = {1}", part, mm)});
    }
    return paths;
}

/// A helix that meets itself mostly does so between neighbouring turns of very different arms. Only the solid shows whether they are
/// separate: the first path that makes one is the suggestion.
void suggest_pitch(core::Finding& refusal, const cam::ArmFunction& arm, const profile::PartSpec& spec) {
    if (spec.cam.path.kind != cam::PathKind::kHelix) return;
    const std::string part = to_string(arm.kind());
    const std::vector<SteeperPath> paths = steeper(part, spec.cam);
    const auto found = std::find_if(paths.begin(), paths.end(), [&](const SteeperPath& path) {
        const auto cam = cam::synthesize_cam(arm, path.options);
        return cam && solid::build_part(*cam, spec.solid);
    });
    refusal.suggestion = found != paths.end() ? found->change
                                              : fmt::format("a base spring of {} whose arms differ less: even with {} its faces meet", part,
                                                            paths.back().change);
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
    if (profile.outputs.has("dxf") && profile.outputs.kerf > 0.0)
        for (const profile::PartSpec* spec : {&profile.k_se, &profile.k_pe})
            exchange::require_kerf(core::mm_from_m(profile.outputs.kerf), spec->solid.hub);
}

core::Findings check_cable_length(const cam::Cam& cam, const profile::Profile& profile) {
    const double length = spec_of(cam.kind, profile).cable_length;
    if (length <= 0.0) return {};
    const drawing::CableLength wound = drawing::cable_length(cam);
    const double least = core::mm_from_m(wound.working + wound.to_anchor);
    const std::string key = std::string(to_string(cam.kind)) + ".cable_length_mm";
    core::Finding f = core::error_finding("cable.length", "the cable reaches from its anchor round the cam's whole working arc",
                                          core::mm_from_m(length), core::Bound::kAtLeast, least, "mm");
    f.where = key;
    f.suggestion = fmt::format("{} = {:.0f} and the free cable: the length counts from the anchor on the cam", key, std::ceil(least));
    f.source = "docs/theory/cams.md, eq. 18";
    return {core::judged(std::move(f), core::Severity::kError)};
}

core::Outcome<cam::Cam> design_cam(cam::PartKind kind, const ResolvedDesign& design) {
    auto cam = cam::synthesize_cam(design.arm(kind), design.spec(kind).cam);
    if (!cam) return cam;
    return with_anchor_placed(std::move(cam).value(), design);
}

core::Outcome<cam::Cam> design_checked_cam(cam::PartKind kind, const ResolvedDesign& design) {
    const profile::Profile& profile = design.profile;
    const profile::PartSpec& spec = design.spec(kind);
    auto cam = design_cam(kind, design);
    if (!cam) return cam;
    const auto outline = solid::outline_part(*cam, spec.solid);
    if (!outline) return outline.refusal();
    core::Findings findings = checks::check({*outline, spec.spring, profile.cable, profile.process, profile.limits});
    core::append(findings, check_cable_length(*cam, profile));
    if (core::any_error(findings)) return findings;
    return cam;
}

core::Outcome<DesignedPart> design_part(cam::PartKind kind, const ResolvedDesign& design) {
    const auto cam = design_cam(kind, design);
    return cam ? design_part(*cam, design) : cam.refusal();
}

core::Outcome<DesignedPart> design_part(const cam::Cam& cam, const ResolvedDesign& design) {
    const profile::Profile& profile = design.profile;
    const profile::PartSpec& spec = design.spec(cam.kind);
    auto part = solid::build_part(cam, spec.solid);
    if (!part) {
        core::Findings refusal = part.refusal();
        for (core::Finding& f : refusal)
            if (f.rule == "solid.validity") suggest_pitch(f, design.arm(cam.kind), spec);
        return refusal;
    }
    core::Findings findings = checks::check({*part, spec.spring, profile.cable, profile.process, profile.limits});
    core::append(findings, check_cable_length(cam, profile));
    if (!core::any_error(findings)) core::append(findings, check_compensated(*part, profile, findings));
    if (core::any_error(findings)) return findings;
    return DesignedPart{std::move(part).value(), std::move(findings)};
}

}  // namespace fusee::pipeline
