#include <vector>

#include "fusee/solid/companions.h"
#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_mill_hole_depth(const Design& design, const Allowed& allowed) {
    return {judge_slenderest_hole(design, {allowed("required"), allowed("review")})};
}

core::Findings measure_mill_inner_edge(const Design& design, const Allowed& allowed) {
    const solid::HubLock lock = design.part.options.hub.lock;
    const bool sharp = lock == solid::HubLock::kKeyway || lock == solid::HubLock::kDFlat;
    if (!sharp) return {};
    core::Finding f = compare(0.0, {allowed("review")});
    f.what = fmt::format("radius in the corners of the {}, drawn sharp", lock == solid::HubLock::kKeyway ? "keyway" : "D-flat");
    f.suggestion = solid::set_screw_change(name(design), design.part.options.hub);
    if (design.part.options.hub.kind == solid::HubKind::kThrough)
        f.suggestion.or_else("the bore broached");  // no broach leaves a blind one
    f.suggestion.or_else(fmt::format("corners of {:g} mm accepted", f.allowed));
    return {f};
}

core::Findings measure_mill_pocket(const Design& design, const Allowed& allowed) {
    const solid::FeatureOptions& features = design.part.options.features;
    if (!is_milled(design) || !has_slot(features)) return {};
    core::Finding f = compare(features.leg_slot_depth / (0.5 * features.leg_slot_width), {allowed("review")});
    f.what = "depth of the spring leg's slot over the radius of its ends";
    f.suggestion = change(design, "features.leg_slot_depth_mm", down(f.allowed * 0.5 * mm_from_m(features.leg_slot_width)));
    return {f};
}

core::Findings measure_mill_slot_width(const Design& design, const Allowed& allowed) {
    const solid::FeatureOptions& features = design.part.options.features;
    const double cutter = process_limits(design.process).cutter_radius;
    if (!is_milled(design) || !has_slot(features) || cutter <= 0.0) return {};
    core::Finding f = compare(mm_from_m(features.leg_slot_width), {allowed("required", mm_from_m(2.0 * cutter))});
    f.what = "width of the spring leg's slot against the cutter's diameter";
    f.suggestion = change(design, "features.leg_slot_width_mm", up(f.allowed));
    return {f};
}

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

core::Findings measure_mill4_swing(const Design& design, const Allowed& allowed) {
    const std::vector<cam::PathPoint> path = contour(design.part.cam);
    if (design.process.kind != ProcessKind::kMill4 || path.empty()) return {};
    const cam::PathPoint& far = farthest(design.part, path);
    const double swing = mm_from_m(2.0 * swept_radius(design.part, far));
    const double space = mm_from_m(std::min(design.process.build_x, design.process.build_y));
    core::Finding f = compare(swing, {allowed("required", space)});
    f.what = "diameter that the part sweeps about its axis";
    locate(f, design, far);
    f.suggestion = scale_arms(design, f.allowed / f.measured);
    return {f};
}

}  // namespace

Rules mill_rules() {
    return {
        {"mill.hole_depth",
         "a hole too deep to drill",
         "milled: depth of the slenderest hole, in its diameters",
         "hole 4 D, at most 10: zekes3d, Xometry",
         {required(kAtMost, "diameters", 10.0), review(kAtMost, "diameters", 4.0)},
         measure_mill_hole_depth,
         is_milled},
        {"mill.inner_edge",
         "a sharp inner edge that no mill can cut",
         "milled: radius in the corners of keyway or D-flat",
         "inner edge R >= 0.25 mm feasible: zekes3d, Xometry",
         {review(kAtLeast, "mm", 0.25)},
         measure_mill_inner_edge,
         is_milled},
        {"mill.pocket",
         "a pocket too deep for the tool that its corners need",
         "milled: depth of the spring leg's slot over the radius of its ends",
         "inner edge R > depth/3: zekes3d, procurabl, neptunelabs, super-ingenuity, Xometry",
         {review(kAtMost, "radii", 3.0)},
         measure_mill_pocket},
        {"mill.slot_width",
         "a slot too narrow for the available cutter",
         "milled: width of the spring leg's slot",
         "process.cutter_radius_mm; 0.25 mm feasible: zekes3d, Xometry",
         {required(kAtLeast, "mm", "twice process.cutter_radius_mm, 0.25 mm by default")},
         measure_mill_slot_width},
        {"mill4.reach",
         "a ball cutter too long and thin to reach the floor between its flanges",
         "four axes: depth of the floor under the flanges, in diameters of the ball that fits it",
         "pocket at most 3 tools deep: zekes3d, Xometry",
         {review(kAtMost, "tools", 3.0)},
         measure_mill4_reach},
        {"mill4.swing",
         "a part that strikes the machine as it turns",
         "four axes: diameter swept as the part turns about its axis",
         "process.build_mm",
         {required(kAtMost, "mm", "the smaller of process.build_mm across the axis")},
         measure_mill4_swing},
    };
}

}  // namespace fusee::checks
