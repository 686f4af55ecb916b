#include "fusee/pipeline/evaluate.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "design/words.h"
#include "each_part.h"
#include "export/compensated.h"
#include "fusee/cam/contact.h"
#include "fusee/checks/check.h"
#include "fusee/checks/rule.h"
#include "fusee/core/folder.h"
#include "fusee/core/units.h"
#include "fusee/drawing/inspection.h"
#include "fusee/pipeline/design_report.h"
#include "fusee/pipeline/make.h"

namespace fusee::pipeline {

namespace {

/// A cam with its anchor in place.
struct AnchoredCam {
    cam::Cam cam;
    std::optional<solid::Part> outline;  ///< its body without a mesh, where the search for the place has made it
};

constexpr std::array kAnchorRules = {"structure.anchor_floor", "structure.anchor", "assembly.anchor_reach", "cable.anchor_load",
                                     "cable.anchor_tail"};

/// A body, and what the rules say about its anchor.
struct Placed {
    std::optional<solid::Part> outline;
    std::optional<core::Severity> severity;  ///< none: the body cannot be made for another reason
};

Placed judged(const cam::Cam& cam, const ResolvedDesign& design) {
    const profile::Profile& p = design.profile;
    const profile::PartSpec& spec = design.spec(cam.kind);
    auto body = solid::outline_part(cam, spec.solid);
    if (!body) {
        if (body.refusal().front().rule != "solid.anchor") return {};
        return {std::nullopt, core::Severity::kError};
    }
    Placed placed{std::move(body).value(), core::Severity::kPass};
    for (const char* id : kAnchorRules)
        for (const core::Finding& f : checks::find_rule(id)->run({*placed.outline, spec.spring, p.cable, p.process, p.limits}))
            if (core::is_broken(f)) placed.severity = std::max(*placed.severity, f.severity);
    return placed;
}

/// A margin that the profile does not state follows from the contour: the planar cam with its anchor at the nearest angle to its own at
/// which no rule about the anchor objects, else at the nearest without an error, else where it is.
AnchoredCam with_anchor_placed(cam::Cam cam, const ResolvedDesign& design) {
    const bool stated = design.profile.places.contains(design.profile.table_of(cam.kind) + ".path.margin_deg");
    if (stated || !cam.closed() || design.spec(cam.kind).solid.features.anchor_hole_diameter <= 0.0) return {std::move(cam), {}};
    std::optional<AnchoredCam> without_error;
    for (const double margin : cam::margins_by_distance(cam)) {
        AnchoredCam moved{cam::with_margin(cam, margin), {}};
        Placed placed = judged(moved.cam, design);
        if (!placed.severity) return {std::move(cam), {}};
        moved.outline = std::move(placed.outline);
        if (*placed.severity == core::Severity::kPass) return moved;
        if (*placed.severity != core::Severity::kError && !without_error) without_error = std::move(moved);
    }
    return without_error ? std::move(*without_error) : AnchoredCam{std::move(cam), {}};
}

/// A steeper path, and its change of the profile.
struct SteeperPath {
    cam::CamOptions options;
    core::Suggestion change;
};

/// Steeper paths by rising pitch. A groove aimed at its guide may also get a constant pitch.
std::vector<SteeperPath> steeper(const std::string& part, const cam::CamOptions& from) {
    const bool aimed = from.path.lead == cam::Lead::kAimedAtGuide;
    std::vector<SteeperPath> paths;
    for (const double share : {1.1, 1.25, 1.5, 2.0, 3.0, 4.0}) {
        cam::CamOptions to = from;
        double& rise = aimed ? to.guide.z : to.path.pitch;
        const std::string mm = fmt::format("{:.2f}", share * core::mm_from_m(rise));
        rise = core::m_from_mm(std::stod(mm));
        paths.push_back({to, core::change(part + (aimed ? ".guide.z_mm" : ".path.pitch_mm"), mm)});
    }
    for (const double cables : {4.0, 6.0, 10.0, 16.0}) {
        if (!aimed) break;
        cam::CamOptions to = from;
        const std::string mm = fmt::format("{:.2f}", cables * core::mm_from_m(from.cable_diameter));
        to.path.lead = cam::Lead::kConstantPitch;
        to.path.pitch = core::m_from_mm(std::stod(mm));
        paths.push_back({to, core::change(part + ".path.lead", core::quoted("constant_pitch")).with(part + ".path.pitch_mm", mm)});
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
    if (found != paths.end())
        refusal.suggestion = found->change;
    else
        refusal.suggestion =
            fmt::format("a base spring of {} whose arms differ less: no steeper path that was tried separates its faces", part);
}

/// "cable.length": nothing if the profile does not state the length.
core::Findings check_cable_length(const cam::Cam& cam, const profile::Profile& profile) {
    const double length = profile.part(cam.kind).cable_length;
    if (length <= 0.0) return {};
    const drawing::CableLength wound = drawing::cable_length(cam);
    const double least = core::mm_from_m(wound.working + wound.to_anchor);
    const std::string key = std::string(to_string(cam.kind)) + ".cable_length_mm";
    core::Finding f = core::error_finding("cable.length", "the cable reaches from its anchor round the cam's whole working arc",
                                          core::mm_from_m(length), core::Bound::kAtLeast, least, "mm");
    f.where = key;
    f.suggestion =
        core::change(key, core::number(std::ceil(least))).noted(" and the free cable: the length counts from the anchor on the cam");
    f.source = "docs/theory/cams.md, eq. 18";
    return {core::judged(std::move(f), core::Severity::kError)};
}

/// The findings of every rule that the body's depth allows.
core::Findings judge_body(const solid::Part& body, const ResolvedDesign& design, Depth depth) {
    const profile::Profile& profile = design.profile;
    const checks::Design judged{body, design.spec(body.cam.kind).spring, profile.cable, profile.process, profile.limits};
    const bool solid = depth == Depth::kSolid;
    core::Findings findings = solid ? checks::check(judged) : checks::check_without_mesh(judged);
    core::append(findings, check_cable_length(body.cam, profile));
    if (solid && !core::any_error(findings)) core::append(findings, check_compensated(body, profile, findings));
    return findings;
}

// Each step takes a part from the depth before it to its own; a refusal becomes the part's findings, and the part stays where it is.

void design_contour(EvaluatedPart& part, const ResolvedDesign& design) {
    auto cam = cam::synthesize_cam(design.arm(part.kind), design.spec(part.kind).cam);
    if (!cam) {
        part.findings = cam.refusal();
        return;
    }
    AnchoredCam anchored = with_anchor_placed(std::move(cam).value(), design);
    part.cam = std::move(anchored.cam);
    part.body = std::move(anchored.outline);
    part.reached = Depth::kCam;
}

void outline(EvaluatedPart& part, const ResolvedDesign& design) {
    if (!part.body) {
        auto body = solid::outline_part(*part.cam, design.spec(part.kind).solid);
        if (!body) {
            part.findings = body.refusal();
            return;
        }
        part.body = std::move(body).value();
    }
    part.reached = Depth::kOutline;
}

void build(EvaluatedPart& part, const ResolvedDesign& design) {
    const profile::PartSpec& spec = design.spec(part.kind);
    auto body = solid::build_part(*part.cam, spec.solid);
    if (!body) {
        part.findings = body.refusal();
        for (core::Finding& f : part.findings)
            if (f.rule == "solid.validity") suggest_pitch(f, design.arm(part.kind), spec);
        return;
    }
    part.body = std::move(body).value();
    part.reached = Depth::kSolid;
}

void deepen_part(EvaluatedPart& part, const ResolvedDesign& design, Depth depth) {
    const auto goes = [&](Depth to) { return part.reached < to && to <= depth; };
    if (goes(Depth::kCam)) design_contour(part, design);
    if (part.reached < Depth::kCam) return;
    if (depth == Depth::kOutline && goes(Depth::kOutline)) {
        outline(part, design);
        if (part.reached == Depth::kOutline) part.findings = judge_body(*part.body, design, Depth::kOutline);
    }
    if (goes(Depth::kSolid)) {
        build(part, design);
        if (part.reached == Depth::kSolid) part.findings = judge_body(*part.body, design, Depth::kSolid);
    }
}

std::vector<EvaluatedPart> evaluate_parts(const ResolvedDesign& design, Depth depth, std::span<const cam::PartKind> kinds) {
    if (depth == Depth::kLaw) return {};
    std::vector<AskedPart> parts = parts_of(design);
    if (!kinds.empty())
        std::erase_if(parts, [&](const AskedPart& part) { return std::find(kinds.begin(), kinds.end(), part.kind) == kinds.end(); });
    return each_part(parts, [&](const AskedPart& part) { return evaluate_part(part.kind, *part.design, depth); });
}

/// Nothing for a single spring, and unless both parts stand and break no rule: a joint of other parts would not be this one.
core::Findings judge_joint(const ResolvedDesign& design, const std::vector<EvaluatedPart>& parts) {
    std::vector<std::shared_ptr<const solid::Part>> solids;
    for (const EvaluatedPart& part : parts)
        if (part.reached == Depth::kSolid && !core::any_error(part.findings)) solids.push_back(std::make_shared<solid::Part>(*part.body));
    return solids.size() == 2 && !design.profile.is_spring() ? assemble(design, solids[0], solids[1]).findings : core::Findings{};
}

Evaluation evaluate_files(const profile::Profile& profile) {
    const core::TemporaryFolder folder;
    core::OutputFolder output(folder.path() / "parts", {.command = "make", .source = profile.file});  // never committed
    auto made = make_parts(profile, output);
    Evaluation all;
    if (!made) {
        all.findings = made.refusal();
        return all;
    }
    all.findings = made->report.findings;
    for (const PartReport* side : made->report.sides())
        all.parts.push_back({.kind = side->part->cam.kind, .name = side->name, .reached = Depth::kFiles, .findings = side->findings});
    all.file_errors = made->report.file_errors();
    all.design = std::move(made).value().resolved;
    return all;
}

}  // namespace

void deepen(EvaluatedPart& part, const ResolvedDesign& design, Depth depth) {
    deepen_part(part, design, depth);
    part.findings = in_words_of(design.profile, std::move(part.findings));
}

EvaluatedPart evaluate_part(cam::PartKind kind, const ResolvedDesign& design, Depth depth) {
    EvaluatedPart part{.kind = kind, .name = design.profile.name_of(kind)};
    deepen(part, design, depth);
    return part;
}

core::Outcome<cam::Cam> design_cam(cam::PartKind kind, const ResolvedDesign& design) {
    EvaluatedPart part = evaluate_part(kind, design, Depth::kCam);
    if (!part.cam) return std::move(part.findings);
    return *std::move(part.cam);
}

core::Outcome<DesignedPart> design_part(cam::PartKind kind, const ResolvedDesign& design) {
    return designed(evaluate_part(kind, design, Depth::kSolid));
}

core::Outcome<DesignedPart> designed(EvaluatedPart part) {
    if (part.reached < Depth::kSolid || core::any_error(part.findings)) return std::move(part.findings);
    return DesignedPart{*std::move(part.body), std::move(part.findings)};
}

core::Findings Evaluation::all() const {
    core::Findings all = findings;
    for (const EvaluatedPart& part : parts) core::append(all, part.findings);
    return all;
}

Evaluation evaluate(ResolvedDesign design, Depth depth, std::span<const cam::PartKind> kinds) {
    Evaluation all;
    all.findings = design.findings;
    all.parts = evaluate_parts(design, depth, kinds);
    if (depth == Depth::kSolid) core::append(all.findings, judge_joint(design, all.parts));
    all.design = std::move(design);
    return all;
}

Evaluation evaluate(const profile::Profile& profile, Depth depth, std::span<const cam::PartKind> kinds) {
    if (depth > Depth::kLaw) require_parts(profile);
    if (depth == Depth::kFiles) return evaluate_files(profile);
    auto design = resolve(profile);
    if (!design) return {.findings = design.refusal()};
    return evaluate(std::move(design).value(), depth, kinds);
}

}  // namespace fusee::pipeline
