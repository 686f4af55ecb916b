#include "means.h"

namespace fusee::checks {

namespace {

constexpr double kShare = 0.5;      // of the shaft's diameter
constexpr double kThinnest = 0.25;  // half of it: a screw that still holds a small torque (practice)

core::Findings measure_shaft_screw(const Design& design, const Allowed& allowed) {
    const solid::HubOptions& hub = design.part.options.hub;
    if (hub.lock != solid::HubLock::kSetScrew || hub.screw_diameter <= 0.0) return {};
    const double screw = mm_from_m(hub.screw_diameter), bore = mm_from_m(hub.bore_diameter);
    core::Finding size = compare(screw, {allowed("least_review", kThinnest * bore), allowed("most_review", kShare * bore)});
    size.what = fmt::format("set screw in a {:g} mm bore: about half the shaft's diameter", bore);
    size.suggestion = change(design, "hub.screw_mm", number(size.allowed));
    const double wall = process_limits(design.process).wall;
    core::Finding boss = compare(mm_from_m(hub.boss_height), {allowed("boss_required", mm_from_m(hub.screw_diameter + 2.0 * wall))});
    boss.what = "height of the boss that holds the set screw and a wall on both sides";
    boss.suggestion = change(design, "hub.boss_height_mm", up(boss.allowed));
    return {size, boss};
}

}  // namespace

Rule shaft_screw() {
    return {"shaft.screw",
            "a set screw that does not suit shaft and boss",
            "set screw's diameter; height of its boss",
            "machinedesign, ficientdesign: about half the shaft's diameter",
            {review(kAtLeast, "mm", "a quarter of the bore", "least_review"), review(kAtMost, "mm", "half the bore", "most_review"),
             required(kAtLeast, "mm", "screw + 2 walls of the process", "boss_required")},
            measure_shaft_screw};
}

}  // namespace fusee::checks
