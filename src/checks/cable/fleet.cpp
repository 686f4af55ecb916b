#include "means.h"

namespace fusee::checks {

namespace {

constexpr double kMost = 4.0;  // [deg]

core::Findings measure_cable_fleet(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    const cam::Contact& worst = worst_contact(cam, [&](const cam::Contact& c) { return std::abs(fleet_from_groove(cam, c)); });
    const bool own = design.cable.max_fleet > 0.0;
    const bool aimed = !cam.closed() && cam.options.path.lead == cam::Lead::kAimedAtGuide;
    const double fleet = deg_from_rad(std::abs(fleet_from_groove(cam, worst)));
    core::Finding f = own ? compare(fleet, {allowed("required", deg_from_rad(design.cable.max_fleet))})
                          : compare(fleet, {allowed("required", kMost), allowed("review")});
    f.what = fmt::format("largest fleet angle{}; the arm in the plane is longer by 1/{:.5f}",
                         aimed ? ", from the direction of the groove" : "", std::cos(worst.fleet));
    locate(f, design, worst.path);
    const double tangent = std::tan(rad_from_deg(f.allowed)), farther = std::abs(std::tan(worst.fleet)) / tangent;
    f.suggestion = change(design, "guide.distance_mm", up(mm_from_m(cam.options.guide.distance + worst.span * (farther - 1.0))))
                       .noted(fmt::format(": a free cable of {} mm there", up(mm_from_m(worst.span * farther))));
    if (!cam.closed() && cam.options.path.lead == cam::Lead::kConstantPitch && cam.working.size() > 1) {
        const double middle = 0.5 * (cam.working.front().path.z + cam.working.back().path.z);
        if (std::abs(cam.options.guide.z - middle) > 0.5 * cam.options.path.pitch)
            f.suggestion.or_else(change(design, "guide.z_mm", number(mm_from_m(middle), 3)).noted(": the guide at half height"));
    }
    if (own) f.source = "cable.max_fleet_deg";
    return {f};
}

}  // namespace

Rule cable_fleet() {
    return {"cable.fleet",
            "the cable leaving the groove's plane at an angle",
            "largest angle between free cable and the contact's plane; of an aimed helix, between free cable and groove",
            "wirerope.net: 2 deg grooved; 4 deg (practice)",
            {required(kAtMost, "deg", "4 deg, or cable.max_fleet_deg"), review(kAtMost, "deg", 2.0)},
            measure_cable_fleet,
            works};
}

}  // namespace fusee::checks
