#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_mill_pocket(const Design& design, const Allowed& allowed) {
    const solid::FeatureOptions& features = design.part.options.features;
    if (!is_milled(design) || !has_slot(features)) return {};
    core::Finding f = compare(features.leg_slot_depth / (0.5 * features.leg_slot_width), {allowed("review")});
    f.what = "depth of the spring leg's slot over the radius of its ends";
    f.suggestion = change(design, "features.leg_slot_depth_mm", down(f.allowed * 0.5 * mm_from_m(features.leg_slot_width)));
    return {f};
}

}  // namespace

Rule mill_pocket() {
    return {"mill.pocket",
            "a pocket too deep for the tool that its corners need",
            "milled: depth of the spring leg's slot over the radius of its ends",
            "inner edge R > depth/3: zekes3d, procurabl, neptunelabs, super-ingenuity, Xometry",
            {review(kAtMost, "radii", 3.0)},
            measure_mill_pocket};
}

}  // namespace fusee::checks
