#include "fusee/solid/companions.h"
#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_cam_arm_range(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    const cam::Contact& least = worst_contact(cam, [](const cam::Contact& c) { return -c.arm.arm; });
    const double largest = worst_contact(cam, [](const cam::Contact& c) { return c.arm.arm; }).arm.arm;
    const solid::HubOptions& hub = design.part.options.hub;
    const bool through = hub.kind == solid::HubKind::kThrough;
    const double wall = process_limits(design.process).wall, half_cable = 0.5 * design.cable.diameter;
    // Overhung: no shaft in the groove's plane, but the floor must not cross the axis.
    const double needed = half_cable + (through ? bore_radius(hub) + wall : 0.0);
    core::Finding f = compare(mm_from_m(least.arm.arm), {allowed("required", mm_from_m(needed))});
    f.what = fmt::format("least arm, of {:.2f} to {:.2f} mm (1 : {:.2f}); it must exceed half a cable{}", mm_from_m(least.arm.arm),
                         mm_from_m(largest), largest / least.arm.arm, through ? ", a wall and the bore" : "");
    locate(f, design, least.path, -half_cable);
    f.suggestion = scale_arms(design, f.allowed / f.measured);
    const double bore = 2.0 * (least.arm.arm - half_cable - wall) - hub.bore_clearance;
    if (through && bore > 0.0) f.suggestion.or_else(change(design, "hub.bore_mm", down(mm_from_m(bore))));
    if (through && !is_stacked(design)) f.suggestion.or_else(solid::overhung_change(name(design), hub));
    return {f};
}

}  // namespace

Rule cam_arm_range() {
    return on_cable({"cam.arm_range",
                     "an arm too short for bore, wall and cable",
                     "least arm",
                     "geometry: r >= bore + wall + d/2",
                     {required(kAtLeast, "mm", "bore + wall + d/2; overhung: d/2")},
                     measure_cam_arm_range,
                     works});
}

}  // namespace fusee::checks
