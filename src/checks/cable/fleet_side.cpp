#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_cable_fleet_side(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    const auto fleet = [&cam](const cam::Contact& c) { return fleet_from_groove(cam, c); };
    const cam::Contact& high = worst_contact(cam, fleet);
    const cam::Contact& low = worst_contact(cam, [&](const cam::Contact& c) { return -fleet(c); });
    const double above = std::max(0.0, fleet(high)), below = std::max(0.0, -fleet(low));
    const cam::Contact& worst = above > below ? high : low;
    core::Finding f = compare(deg_from_rad(std::abs(above - below)), {allowed("review")});
    f.what = fmt::format("fleet angle {:.2f} deg upwards, {:.2f} deg downwards: the guide is off the middle of the groove",
                         deg_from_rad(above), deg_from_rad(below));
    locate(f, design, worst.path);
    f.suggestion =
        change(design, "guide.z_mm", number(mm_from_m(cam.options.guide.z - worst.span * std::tan(0.5 * (high.fleet + low.fleet))), 3));
    return {f};
}

}  // namespace

Rule cable_fleet_side() {
    return {"cable.fleet_side",
            "a guide off the middle, so that the cable rubs on one flank only",
            "largest fleet angle to one side less the largest to the other",
            "wirerope.net: 1.5 deg on a smooth drum",
            {review(kAtMost, "deg", 1.5)},
            measure_cable_fleet_side,
            works};
}

}  // namespace fusee::checks
