#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_assembly_leg_pressure(const Design& design, const Allowed& allowed) {
    const solid::FeatureOptions& slot = design.part.options.features;
    const double force = leg_force(design), depth = slot.leg_slot_depth, most = bearing_strength(design);
    // The wire tilts in its slot: the pressure falls linearly from the mouth to 0 at the bottom.
    core::Finding f = compare(2.0 * force / (design.spring.wire_diameter * depth) / kPaPerMPa, {allowed("review", most / kPaPerMPa)});
    f.what = fmt::format("pressure of the spring's leg on the wall of its slot, {:.1f} N on {:.3g} mm of wire", force, mm_from_m(depth));
    const double deeper = depth * f.measured / f.allowed;
    if (deeper + process_limits(design.process).loaded_wall <= design.part.z_high - design.part.z_low)
        f.suggestion = change(design, "features.leg_slot_depth_mm", up(mm_from_m(deeper)));
    f.suggestion.or_else(change(design, "features.leg_slot_radius_mm", up(mm_from_m(slot.leg_slot_radius) * f.measured / f.allowed)));
    return {f};
}

}  // namespace

Rule assembly_leg_pressure() {
    return {"assembly.leg_pressure",
            "a spring's leg that digs into the wall of its slot",
            "2 M/(slot radius x wire x slot depth) at the largest torque",
            "triangular contact of a bar in a socket; the material's bearing strength (table 5)",
            {review(kAtMost, "MPa", "cable.max_pressure_MPa, or the material's bearing strength (table 5)")},
            measure_assembly_leg_pressure,
            has_torsion_leg_slot,
            {need::kWire}};
}

}  // namespace fusee::checks
