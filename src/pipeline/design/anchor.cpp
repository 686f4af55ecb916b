#include "anchor.h"

#include <array>

#include "fusee/cam/contact.h"
#include "fusee/checks/check.h"
#include "fusee/checks/rule.h"

namespace fusee::pipeline {

namespace {

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

}  // namespace

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

}  // namespace fusee::pipeline
