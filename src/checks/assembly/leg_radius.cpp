#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_assembly_leg_radius(const Design& design, const Allowed& allowed) {
    const solid::FeatureOptions& features = design.part.options.features;
    const spring::BaseSpring& s = design.spring;
    const double aside = std::abs(features.leg_slot_radius - 0.5 * s.coil_diameter) + 0.5 * (s.wire_diameter - features.leg_slot_length);
    core::Finding f = compare(mm_from_m(std::max(0.0, aside)), {allowed("review")});
    f.what = fmt::format("protrusion of an axial leg, {:.2f} mm from the axis, beyond its slot", mm_from_m(0.5 * s.coil_diameter));
    f.where = at_leg_slot(design);
    f.suggestion = change(design, "features.leg_slot_radius_mm", number(mm_from_m(0.5 * s.coil_diameter), 4));
    return {f};
}

}  // namespace

Rule assembly_leg_radius() {
    return {"assembly.leg_radius",
            "a slot that misses the spring's leg",
            "protrusion of the leg, at the coil's radius, beyond its slot",
            "geometry: an axial leg stands at D/2",
            {review(kAtMost, "mm", 0.0)},
            measure_assembly_leg_radius,
            has_leg_slot,
            {need::kWire, need::kCoil}};
}

}  // namespace fusee::checks
