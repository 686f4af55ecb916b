#include "means.h"

namespace fusee::checks {

namespace {

/// Half of the zone IT9 of ISO 286 that a keyway of this width has, in the standard's loose fit JS9 [m].
double half_zone(double width) { return width <= 3e-3 ? 12.5e-6 : width <= 6e-3 ? 15e-6 : 18e-6; }

bool has_key(const Design& design) { return design.part.options.hub.lock == solid::HubLock::kKeyway; }

core::Findings measure_shaft_key_fit(const Design& design, const Allowed& allowed) {
    const solid::HubOptions& hub = design.part.options.hub;
    const bool by_hand = hub.key_fit == solid::KeyFit::kByHand;
    const double tolerance = process_limits(design.process).tolerance;
    core::Finding f = compare(by_hand ? 0.0 : mm_from_m(tolerance), {allowed("review", mm_from_m(half_zone(hub.key_width)))});
    f.what = by_hand
                 ? fmt::format("tolerance of a keyway of {:g} mm that is filed or broached to its key", mm_from_m(hub.key_width))
                 : fmt::format("tolerance of a keyway of {:g} mm as made by {}: the part may turn by {:.1f} deg on its key, or not take it",
                               mm_from_m(hub.key_width), to_string(design.process.kind), deg_from_rad(4.0 * tolerance / hub.bore_diameter));
    f.suggestion = change(design, "hub.key_fit", quoted("by_hand"))
                       .noted(fmt::format(": filed{} to +-{:g} mm", hub.kind == solid::HubKind::kThrough ? " or broached" : "", f.allowed));
    return {f};
}

}  // namespace

Rule shaft_key_fit() {
    return {"shaft.key_fit",
            "a keyway with a fit that the process cannot hold",
            "the process's tolerance of the keyway's width; 0 if hub.key_fit says that it is fitted by hand",
            "DIN 6885-1: hub keyway P9 or JS9, half of IT9 by ISO 286",
            {review(kAtMost, "mm", "half of IT9: 0.0125 up to 3 mm of width, 0.015 up to 6, else 0.018")},
            measure_shaft_key_fit,
            has_key};
}

}  // namespace fusee::checks
