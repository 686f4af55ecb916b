#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_shaft_hub_wall(const Design& design, const Allowed& allowed) {
    const solid::HubOptions& hub = design.part.options.hub;
    if (hub.boss_diameter <= 0.0 || hub.boss_height <= 0.0) return {};
    const double radius = hub_radius(hub);
    const ProcessLimits process = process_limits(design.process);
    core::Finding f = compare(mm_from_m(0.5 * hub.boss_diameter - radius),
                              {allowed("required", mm_from_m(process.wall)), allowed("review", mm_from_m(process.loaded_wall))});
    f.what = "wall of the boss around bore and keyway";
    f.suggestion = change(design, "hub.boss_mm", up(2.0 * (mm_from_m(radius) + f.allowed)));
    return {f};
}

}  // namespace

Rule shaft_hub_wall() {
    return {"shaft.hub_wall",
            "a boss that bursts around its shaft",
            "wall of the boss around bore and keyway",
            "the process's walls: thin required, loaded recommended",
            {of_process(required(kAtLeast, "mm", "the process's wall")), of_process(review(kAtLeast, "mm", "the process's loaded wall"))},
            measure_shaft_hub_wall};
}

}  // namespace fusee::checks
