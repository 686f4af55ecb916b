#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_spring_unwinding(const Design& design, const Allowed& allowed) {
    if (design.spring.kind != spring::BaseKind::kTorsion || design.part.cam.working.empty()) return {};
    const cam::Contact& least = worst_contact(design.part.cam, [](const cam::Contact& c) { return -c.arm.state; });
    core::Finding f = compare(least.arm.state, {allowed("review")});
    f.what = "least winding of the base spring, preload included: a jerk may unwind it";
    f.where = where(design, least.path.psi);
    f.suggestion = change(design, "spring.preload_rad", up(design.spring.preload + f.allowed - f.measured));
    return {f};
}

}  // namespace

Rule spring_unwinding() {
    return {"spring.unwinding",
            "a torsion spring loaded against its winding",
            "least winding, preload included",
            "loaded only in the winding direction: katyspring; 0.1 rad (practice)",
            {review(kAtLeast, "rad", 0.1)},
            measure_spring_unwinding};
}

}  // namespace fusee::checks
