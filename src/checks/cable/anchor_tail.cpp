#include "means.h"

namespace fusee::checks {

namespace {

constexpr int kSteps = 32;

core::Findings measure_cable_anchor_tail(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    if (!cam.path || cam.working.empty()) return {};
    const cam::Contact& nearest = worst_contact(cam, [&cam](const cam::Contact& c) { return -wound_angle(cam, c); });
    const double angle = wound_angle(cam, nearest), step = cam.options.torque_sign * angle / kSteps;
    double length = 0.0;
    for (int i = 0; i < kSteps; ++i) length += cam.path(cam.anchor_psi + (i + 0.5) * step).rho * angle / kSteps;
    core::Finding f = compare(mm_from_m(length), {allowed("review", mm_from_m(2.0 * design.cable.diameter))});
    f.what = "length of cable that stays wound between its anchor and the working arc";
    f.where = at_anchor(design);
    f.suggestion = change(design, "path.margin_deg", up(deg_from_rad(cam.options.path.margin) * f.allowed / f.measured));
    return {f};
}

}  // namespace

Rule cable_anchor_tail() {
    return {"cable.anchor_tail",
            "a cable that is lifted off its working floor by the bend into its hole",
            "length that stays wound between the anchor and the working arc",
            "two cable diameters (practice)",
            {review(kAtLeast, "mm", "two cable diameters")},
            measure_cable_anchor_tail};
}

}  // namespace fusee::checks
