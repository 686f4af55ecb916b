#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "fusee/core/units.h"
#include "fusee/design/robust.h"
#include "fusee/drawing/inspection.h"
#include "fusee/pipeline/design.h"
#include "fusee/pipeline/simulate.h"

namespace fusee::pipeline {

design::Drawing drawing_of(const profile::Profile& profile, const spring::SpringLawPtr& law) {
    return {actuator_of(profile, law), profile.k_se.spring,
            spring::in_series_with_cable(profile.k_pe.spring, profile.k_pe.allowance.cable_compliance)};
}

std::vector<report::StretchSide> stretch_sides(const profile::Profile& profile, const spring::SpringLawPtr& law) {
    std::vector<report::StretchSide> sides;
    if (!profile.has_parts) return sides;
    for (const cam::PartKind kind : {cam::PartKind::kSeries, cam::PartKind::kParallel}) {
        const profile::PartSpec& spec = spec_of(kind, profile);
        const cam::ArmFunction arm(kind, law, spec.spring, profile.rig.capstan_radius, spec.allowance);
        const cam::ArmPoint most = arm.at_load(law->loads().high);
        if (most.stretch.turn != 0.0) sides.push_back({kind, most});
    }
    return sides;
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

}  // namespace fusee::pipeline
