#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_structure_slot_floor(const Design& design, const Allowed& allowed) {
    const solid::FeatureOptions& features = design.part.options.features;
    if (!has_slot(features)) return {};
    const ProcessLimits process = process_limits(design.process);
    const double left = design.part.z_high - design.part.z_low - features.leg_slot_depth;
    core::Finding f =
        compare(mm_from_m(left), {allowed("required", mm_from_m(process.wall)), allowed("review", mm_from_m(process.loaded_wall))});
    f.what = "material under the spring leg's slot";
    f.where = at_leg_slot(design);
    const double depth = mm_from_m(features.leg_slot_depth) + f.measured - f.allowed;
    f.suggestion = depth > 0.0 ? change(design, "features.leg_slot_depth_mm", down(depth))
                               : change("groove.rib_mm", up(mm_from_m(design.part.options.groove.rib) + f.allowed - f.measured));
    return {f};
}

}  // namespace

Rule structure_slot_floor() {
    return {"structure.slot_floor",
            "the spring leg's slot breaking through the part",
            "material under the slot",
            "the process's walls: thin required, loaded recommended",
            {of_process(required(kAtLeast, "mm", "the process's wall")), of_process(review(kAtLeast, "mm", "the process's loaded wall"))},
            measure_structure_slot_floor};
}

}  // namespace fusee::checks
