#include "anchor.h"

#include <array>
#include <optional>

#include "fusee/cam/anchor.h"
#include "fusee/checks/check.h"
#include "fusee/checks/rule.h"

namespace fusee::pipeline {

namespace {

constexpr std::array kAnchorRules = {"structure.anchor_floor", "structure.anchor", "assembly.anchor_reach", "cable.anchor_load",
                                     "cable.anchor_tail"};

/// What the rules say about the anchor at its present place; none: the body cannot be made for another reason.
std::optional<core::Severity> judged(const cam::Cam& cam, const ResolvedDesign& design) {
    const profile::Profile& p = design.profile;
    const profile::PartSpec& spec = design.spec(cam.kind);
    const auto body = solid::outline_part(cam, spec.solid);
    if (!body) {
        if (body.refusal().front().rule != "solid.anchor") return std::nullopt;
        return core::Severity::kError;
    }
    core::Severity worst = core::Severity::kPass;
    for (const char* id : kAnchorRules)
        for (const core::Finding& f : checks::find_rule(id)->run({*body, spec.spring, p.cable, p.process, p.limits}))
            if (core::is_broken(f)) worst = std::max(worst, f.severity);
    return worst;
}

}  // namespace

cam::Cam with_anchor_placed(cam::Cam cam, const ResolvedDesign& design) {
    const bool stated = design.profile.places.contains(std::string(to_string(cam.kind)) + ".path.margin_deg");
    if (stated || !cam.closed() || design.spec(cam.kind).solid.features.anchor_hole_diameter <= 0.0) return cam;
    std::optional<double> without_error;
    for (const double margin : cam::margins_by_distance(cam)) {
        const cam::Cam moved = cam::with_margin(cam, margin);
        const auto severity = judged(moved, design);
        if (!severity) return cam;
        if (*severity == core::Severity::kPass) return moved;
        if (*severity != core::Severity::kError && !without_error) without_error = margin;
    }
    return without_error ? cam::with_margin(std::move(cam), *without_error) : cam;
}

}  // namespace fusee::pipeline
