#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_mill_slot_width(const Design& design, const Allowed& allowed) {
    const solid::FeatureOptions& features = design.part.options.features;
    const double cutter = process_limits(design.process).cutter_radius;
    if (!is_milled(design) || !has_slot(features) || cutter <= 0.0) return {};
    core::Finding f = compare(mm_from_m(features.leg_slot_width), {allowed("required", mm_from_m(2.0 * cutter))});
    f.what = "width of the spring leg's slot against the cutter's diameter";
    f.suggestion = change(design, "features.leg_slot_width_mm", up(f.allowed));
    return {f};
}

}  // namespace

Rule mill_slot_width() {
    return {"mill.slot_width",
            "a slot too narrow for the available cutter",
            "milled: width of the spring leg's slot",
            "process.cutter_radius_mm; 0.25 mm feasible: zekes3d, Xometry",
            {required(kAtLeast, "mm", "twice process.cutter_radius_mm, 0.25 mm by default")},
            measure_mill_slot_width};
}

}  // namespace fusee::checks
