#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_shaft_bore_fit(const Design& design, const Allowed& allowed) {
    const solid::HubOptions& hub = design.part.options.hub;
    const core::Range fit = process_limits(design.process).fit;
    core::Finding f =
        compare(mm_from_m(hub.bore_clearance), {allowed("low_review", mm_from_m(fit.low)), allowed("high_review", mm_from_m(fit.high))});
    f.what = fmt::format("clearance of the bore on a shaft of {:g} mm", mm_from_m(hub.bore_diameter));
    f.suggestion = change(design, "hub.clearance_mm", number(f.allowed));
    return {f};
}

}  // namespace

Rule shaft_bore_fit() {
    return {"shaft.bore_fit",
            "a bore too tight or too loose on its shaft",
            "clearance of the bore on the shaft, in diameter",
            "clearances of printing: 3dservicesusa, cifproto, arti90, layerx3d; the others (practice)",
            {of_process(review(kAtLeast, "mm", "the process's least fit", "low_review")),
             of_process(review(kAtMost, "mm", "the process's largest fit", "high_review"))},
            measure_shaft_bore_fit};
}

}  // namespace fusee::checks
