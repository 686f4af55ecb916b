#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_assembly_leg_width(const Design& design, const Allowed& allowed) {
    const solid::FeatureOptions& features = design.part.options.features;
    const double wire = design.spring.wire_diameter;
    core::Finding f = compare(mm_from_m(features.leg_slot_width - wire), {allowed("required"), allowed("review")});
    f.what = fmt::format("play of the spring's leg of {:g} mm in its slot", mm_from_m(wire));
    f.where = at_leg_slot(design);
    f.suggestion = change(design, "features.leg_slot_width_mm", number(mm_from_m(wire) + f.allowed, 4));
    return {f};
}

}  // namespace

Rule assembly_leg_width() {
    return {"assembly.leg_width",
            "a slot too narrow or too wide for the spring's leg",
            "width of the spring leg's slot less the wire",
            "0 to 0.5 mm (practice)",
            {required(kAtLeast, "mm", 0.0), review(kAtMost, "mm", 0.5)},
            measure_assembly_leg_width,
            has_leg_slot,
            {need::kWire}};
}

}  // namespace fusee::checks
