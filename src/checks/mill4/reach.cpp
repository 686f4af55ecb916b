#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_mill4_reach(const Design& design, const Allowed& allowed) {
    if (design.process.kind != ProcessKind::kMill4) return {};
    const solid::PartOptions& options = design.part.options;
    const double tool = 2.0 * options.groove.radius_ratio * design.cable.diameter;
    const double depth = options.groove.depth_ratio * design.cable.diameter + options.flange_height;
    core::Finding f = compare(depth / tool, {allowed("review")});
    f.what = fmt::format("depth of the groove under its flanges for a ball of {:.3f} mm", mm_from_m(tool));
    f.where = along_groove(design);
    f.suggestion = change(design, "flange_height_mm", down(std::max(0.0, mm_from_m(options.flange_height - depth + f.allowed * tool))));
    return {f};
}

}  // namespace

Rule mill4_reach() {
    return {"mill4.reach",
            "a ball cutter too long and thin to reach the floor between its flanges",
            "four axes: depth of the floor under the flanges, in diameters of the ball that fits it",
            "pocket at most 3 tools deep: zekes3d, Xometry",
            {review(kAtMost, "tools", 3.0)},
            measure_mill4_reach};
}

}  // namespace fusee::checks
