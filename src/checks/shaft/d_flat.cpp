#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_shaft_d_flat(const Design& design, const Allowed& allowed) {
    const solid::HubOptions& hub = design.part.options.hub;
    if (hub.lock != solid::HubLock::kDFlat) return {};
    core::Finding f = compare(hub.flat_depth / hub.bore_diameter, {allowed("low_review"), allowed("high_review")});
    f.what = fmt::format("depth of the flat over the bore of {:g} mm", mm_from_m(hub.bore_diameter));
    f.suggestion = change(design, "hub.flat_depth_mm", number(mm_from_m(f.allowed * hub.bore_diameter), 4));
    return {f};
}

}  // namespace

Rule shaft_d_flat() {
    return {"shaft.d_flat",
            "a flat too shallow to hold, or so deep that it weakens the shaft",
            "D-flat: its depth over the bore",
            "0.05 to 0.25 (practice)",
            {review(kAtLeast, "", 0.05, "low_review"), review(kAtMost, "", 0.25, "high_review")},
            measure_shaft_d_flat};
}

}  // namespace fusee::checks
