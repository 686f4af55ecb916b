#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_stack_wire(const Design& design, const Allowed& allowed) {
    const solid::FeatureOptions& features = design.part.options.features;
    const double hole = features.anchor_hole_diameter, slot = has_slot(features) ? features.leg_slot_width : 0.0;
    if (!is_stacked(design) || (hole <= 0.0 && slot <= 0.0)) return {};
    const bool at_slot = slot > 0.0 && (hole <= 0.0 || slot < hole);
    core::Finding f =
        compare(mm_from_m(0.5 * (at_slot ? slot : hole)), {allowed("required", mm_from_m(process_limits(design.process).cutter_radius))});
    f.what = fmt::format("least inner radius of the plates: {}", at_slot ? "ends of the spring leg's slot" : "anchor hole");
    f.suggestion = change(design, at_slot ? "features.leg_slot_width_mm" : "features.anchor_hole_mm", up(2.0 * f.allowed));
    return {f};
}

}  // namespace

Rule stack_wire() {
    return {"stack.wire",
            "an inner radius that the wire or beam cannot cut",
            "plates: least radius of anchor hole and slot's ends",
            "wire radius + gap 0.145 mm, half a laser's kerf 0.1 mm (practice)",
            {required(kAtLeast, "mm", "process.cutter_radius_mm: wire radius + gap, half the kerf")},
            measure_stack_wire};
}

}  // namespace fusee::checks
