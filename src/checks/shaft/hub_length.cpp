#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_shaft_hub_length(const Design& design, const Allowed& allowed) {
    const solid::HubOptions& hub = design.part.options.hub;
    const bool through = hub.kind == solid::HubKind::kThrough;
    core::Finding f = compare(bore_length(design.part) / hub.bore_diameter, {allowed(through ? "through_review" : "overhung_review")});
    f.what = fmt::format("length of the bore over its diameter of {:g} mm", mm_from_m(hub.bore_diameter));
    f.suggestion =
        change(design, "hub.boss_height_mm", up(mm_from_m(hub.boss_height) + (f.allowed - f.measured) * mm_from_m(hub.bore_diameter)));
    if (hub.boss_diameter <= 0.0)
        f.suggestion.with(key_of(design, "hub.boss_mm"),
                          up(mm_from_m(2.0 * (hub_radius(hub) + process_limits(design.process).loaded_wall))));
    return {f};
}

}  // namespace

Rule shaft_hub_length() {
    return {"shaft.hub_length",
            "a hub so short that the part tilts on its shaft",
            "length over which the bore holds the shaft, in bore diameters",
            "through: half a diameter, overhung: one (practice)",
            {review(kAtLeast, "diameters", 0.5, "through_review"), review(kAtLeast, "diameters", 1.0, "overhung_review")},
            measure_shaft_hub_length};
}

}  // namespace fusee::checks
