#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_sla_drain(const Design& design, const Allowed& allowed) {
    const solid::HubOptions& hub = design.part.options.hub;
    if (design.process.kind != ProcessKind::kSla || hub.kind != solid::HubKind::kOverhung) return {};
    const double bore = 2.0 * bore_radius(hub);
    core::Finding f = compare(bore_length(design.part) / bore, {allowed("review")});
    f.what = "depth of the blind bore over its diameter: resin stays in it";
    f.suggestion = "a drain hole at its end";
    f.suggestion.or_else(
        change(design, "hub.boss_height_mm", down(mm_from_m(hub.boss_height) - (f.measured - f.allowed) * mm_from_m(bore))));
    return {f};
}

}  // namespace

Rule sla_drain() {
    return {"sla.drain",
            "a blind bore that traps resin",
            "SLA, overhung: depth of the blind bore, in its diameters",
            "one diameter (practice)",
            {review(kAtMost, "diameters", 1.0)},
            measure_sla_drain};
}

}  // namespace fusee::checks
