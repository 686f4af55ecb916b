#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_assembly_anchor_reach(const Design& design, const Allowed& allowed) {
    const spring::BaseSpring& s = design.spring;
    const auto hole = anchor_hole(design.part);
    const double outside = 0.5 * (s.coil_diameter + s.wire_diameter);
    core::Finding f = compare(mm_from_m(std::hypot(hole->centre[0], hole->centre[1]) - hole->radius - outside), {allowed("review")});
    f.what = fmt::format("distance from the spring's coils, {:.2f} mm from the axis, to the anchor hole", mm_from_m(outside));
    locate(f, design, hole->at, -hole->radius);
    f.suggestion = change(design, "spring.coil_mm", down(mm_from_m(s.coil_diameter) - 2.0 * (f.allowed - f.measured)));
    return {f};
}

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

core::Findings measure_assembly_leg_width(const Design& design, const Allowed& allowed) {
    const solid::FeatureOptions& features = design.part.options.features;
    const double wire = design.spring.wire_diameter;
    core::Finding f = compare(mm_from_m(features.leg_slot_width - wire), {allowed("required"), allowed("review")});
    f.what = fmt::format("play of the spring's leg of {:g} mm in its slot", mm_from_m(wire));
    f.where = at_leg_slot(design);
    f.suggestion = change(design, "features.leg_slot_width_mm", number(mm_from_m(wire) + f.allowed, 4));
    return {f};
}

core::Findings measure_assembly_rotation_gap(const Design& design, const Allowed& allowed) {
    const auto gap = guide_gap(design.part);
    if (!gap || *gap < 0.0) return {};  // collision: cam.contour_radius reports it
    core::Finding f = compare(mm_from_m(*gap), {allowed("review")});
    f.what = "gap between the turning part and its guide";
    f.suggestion = change(design, "guide.distance_mm", up(mm_from_m(design.part.cam.options.guide.distance) + f.allowed - f.measured));
    return {f};
}

core::Findings measure_assembly_thread(const Design& design, const Allowed& allowed) {
    const double hole = design.part.options.features.anchor_hole_diameter, d = design.cable.diameter;
    if (hole <= 0.0) return {};
    core::Finding f = compare(hole / d, {allowed("required"), allowed("review")});
    f.what = "diameter of the anchor hole, through which the cable is threaded";
    f.where = at_anchor(design);
    f.suggestion = change(design, "features.anchor_hole_mm", up(mm_from_m(f.allowed * d)));
    return {f};
}

}  // namespace

Rules assembly_rules() {
    return {
        on_cable({"assembly.anchor_reach",
                  "an anchor hidden under the spring",
                  "distance from the torsion spring's outside to the anchor hole on the top face",
                  "geometry: the knot is tied beside the spring",
                  {review(kAtLeast, "mm", 0.0)},
                  measure_assembly_anchor_reach,
                  has_torsion_anchor,
                  {need::kWire, need::kCoil}}),
        {"assembly.leg_pressure",
         "a spring's leg that digs into the wall of its slot",
         "2 M/(slot radius x wire x slot depth) at the largest torque",
         "triangular contact of a bar in a socket; the material's bearing strength (table 5)",
         {review(kAtMost, "MPa", "cable.max_pressure_MPa, or the material's bearing strength (table 5)")},
         measure_assembly_leg_pressure,
         has_torsion_leg_slot,
         {need::kWire}},
        {"assembly.leg_radius",
         "a slot that misses the spring's leg",
         "protrusion of the leg, at the coil's radius, beyond its slot",
         "geometry: an axial leg stands at D/2",
         {review(kAtMost, "mm", 0.0)},
         measure_assembly_leg_radius,
         has_leg_slot,
         {need::kWire, need::kCoil}},
        {"assembly.leg_width",
         "a slot too narrow or too wide for the spring's leg",
         "width of the spring leg's slot less the wire",
         "0 to 0.5 mm (practice)",
         {required(kAtLeast, "mm", 0.0), review(kAtMost, "mm", 0.5)},
         measure_assembly_leg_width,
         has_leg_slot,
         {need::kWire}},
        {"assembly.rotation_gap",
         "a part that touches its guide as it turns",
         "gap between the circle that lips and flanges sweep and the guide",
         "1 mm (practice)",
         {review(kAtLeast, "mm", 1.0)},
         measure_assembly_rotation_gap},
        on_cable({"assembly.thread",
                  "a cable that does not go through its hole",
                  "anchor hole over the cable",
                  "1.2 d, at least d (practice)",
                  {required(kAtLeast, "d", 1.0), review(kAtLeast, "d", 1.2)},
                  measure_assembly_thread}),
    };
}

}  // namespace fusee::checks
