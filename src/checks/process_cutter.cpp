#include <fmt/format.h>

#include "fusee/checks/limits.h"
#include "fusee/core/units.h"
#include "measure.h"
#include "rules.h"
#include "shape.h"

namespace fusee::checks {

namespace {

constexpr double kToolsDeep = 3.0;  // pocket depth in tool diameters

core::Finding floor_radius(const Design& design, double cutter_mm) {
    const double ratio = design.part.options.groove.radius_ratio;
    core::Finding f = at_least(core::mm_from_m(ratio * design.cable.diameter), {cutter_mm, {}}, "mm");
    f.what = "radius of the groove's floor, which the ball cutter must fit";
    f.suggestion = fmt::format("process.cutter_radius_mm = {}, or cable.diameter_mm = {}", down(f.measured), up(cutter_mm / ratio));
    return f;
}

core::Findings run(const Design& design) {
    const double cutter = core::mm_from_m(process_limits(design.process).cutter_radius);
    if (design.process.kind != ProcessKind::kMill || cutter <= 0.0) return {};
    core::Findings findings{floor_radius(design, cutter)};
    const solid::FeatureOptions& features = design.part.options.features;
    if (!has_slot(features)) return findings;
    const double width = core::mm_from_m(features.leg_slot_width);
    core::Finding slot = at_least(width, {2.0 * cutter, {}}, "mm");
    slot.what = "width of the spring leg's slot, which the cutter must enter";
    slot.suggestion = fmt::format("{}.features.leg_slot_width_mm = {}", name(design), up(slot.allowed));
    core::Finding depth = at_most(core::mm_from_m(features.leg_slot_depth), {{}, kToolsDeep * width}, "mm");
    depth.what = "depth of the spring leg's slot, for a tool as wide as the slot";
    depth.suggestion = fmt::format("{}.features.leg_slot_depth_mm = {}", name(design), down(depth.allowed));
    findings.insert(findings.end(), {slot, depth});
    return findings;
}

}  // namespace

Rule process_cutter() {
    return {"process.cutter", "a groove or slot that no cutter at hand fits into",
            "process.cutter_radius_mm; inner edge 0.25 mm, pocket 3 tools deep: zekes3d, Xometry", run};
}

}  // namespace fusee::checks
