#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_collision_rim_undercut(const Design& design, const Allowed& allowed) {
    if (design.process.kind != ProcessKind::kMill) return {};
    const solid::GrooveOptions& groove = design.part.options.groove;
    const double depth = mm_from_m(groove.depth_ratio * design.cable.diameter);
    core::Finding f = compare(depth, {allowed("review")});
    f.what = "depth of the groove under its upper flange, out of reach of a tool along the axis";
    f.where = along_groove(design);
    f.suggestion = fmt::format("a 4th axis, a form cutter of {:.3f} mm radius", mm_from_m(groove.radius_ratio * design.cable.diameter));
    if (design.part.cam.closed()) f.suggestion.or_else("two plates split in the plane z 0 mm");
    return {f};
}

}  // namespace

Rule collision_rim_undercut() {
    return {"collision.rim_undercut",
            "a rim groove that three axes cannot reach",
            "three axes: depth of the groove under its upper flange",
            "geometry: the groove opens sideways",
            {review(kAtMost, "mm", 0.0)},
            measure_collision_rim_undercut};
}

}  // namespace fusee::checks
