#include "fusee/checks/thread.h"
#include "means.h"

namespace fusee::checks {

namespace {

constexpr double kHold = 0.25;  // of the screw's force, as friction on the shaft

bool has_screw(const Design& design) {
    const solid::HubOptions& hub = design.part.options.hub;
    return works(design) && hub.lock == solid::HubLock::kSetScrew && hub.screw_diameter > 0.0 && hub.boss_diameter > hub.bore_diameter;
}

core::Findings measure_shaft_thread_strip(const Design& design, const Allowed& allowed) {
    const solid::HubOptions& hub = design.part.options.hub;
    const Material material = material_of(design.process);
    const double force = 2.0 * largest_torque(design.part.cam) / (kHold * hub.bore_diameter);
    const double length = 0.5 * (hub.boss_diameter - hub.bore_diameter);
    const double bears = thread_strength(hub.screw_diameter, length, material);
    core::Finding f = compare(bears / force, {allowed("required")});
    f.what = fmt::format("safety of the screw's thread in {:.3g} mm of {}: {:.0f} N against the {:.0f} N that hold the shaft",
                         mm_from_m(length), material.name, bears, force);
    f.suggestion = change(design, "hub.boss_mm", up(mm_from_m(hub.bore_diameter + 2.0 * length * f.allowed / f.measured)))
                       .or_else(fmt::format("a nut or insert for {:.0f} N", force));
    return {f};
}

}  // namespace

Rule shaft_thread_strip() {
    return {
        "shaft.thread_strip",
        "a set screw whose thread strips out of the boss",
        "set screw: shear strength of its thread in the boss's wall over the force that holds the largest torque",
        "shear area 0.875 pi d L of a 60 deg thread; ficientdesign: the shaft is held by a quarter of the screw's force; shear strength "
        "half of the tensile one (practice)",
        {required(kAtLeast, "", 1.0)},
        measure_shaft_thread_strip,
        has_screw};
}

}  // namespace fusee::checks
