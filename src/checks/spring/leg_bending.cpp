#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_spring_leg_bending(const Design& design, const Allowed& allowed) {
    const spring::BaseSpring& s = design.spring;
    const double radius = leg_bend_radius(s), force = leg_force(design);
    const double moment = force * (radius + 0.5 * s.wire_diameter + 0.5 * design.part.options.features.leg_slot_depth);
    const double share = spring::allowed_share(s);
    core::Finding f =
        compare(spring::bend_stress(s, moment, radius) / kPaPerMPa, {allowed("required", share * spring::tensile_strength(s) / kPaPerMPa)});
    f.what = fmt::format("bending stress where the leg leaves the coil, {:.1f} N in the middle of its slot, bent to {:.3g} mm inside",
                         force, mm_from_m(radius));
    f.suggestion = limit_load(design, design.spring.rate * largest_state(design) * f.allowed / f.measured);
    // The moment's lever, less the part that the slot's depth does not change.
    const double depth = 2.0 * (moment / force * f.allowed / f.measured - radius - 0.5 * s.wire_diameter);
    if (depth > 0.0) f.suggestion.or_else(change(design, "features.leg_slot_depth_mm", down(mm_from_m(depth))));
    return {f};
}

}  // namespace

Rule spring_leg_bending() {
    return {"spring.leg_bending",
            "a torsion spring's leg breaking at its bend",
            "bending stress of the axial leg at its bend: force M/(slot radius) in the middle of the slot's depth, factor q of the bend",
            "EN 13906-3: 0.7 of the strength, q of w = 2 r/d + 1; bend of at least d: Autodesk Inventor, torsion spring calculation",
            {required(kAtMost, "MPa", "stress_share of the wire's strength, 0.7 by default")},
            measure_spring_leg_bending,
            has_torsion_leg_slot,
            {need::kWire, need::kStrength}};
}

}  // namespace fusee::checks
