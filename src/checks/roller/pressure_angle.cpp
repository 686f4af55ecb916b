#include "means.h"

namespace fusee::checks {

namespace {

/// The base radius for a pressure angle of `angle` at this arm [m].
double base_for(const cam::ArmPoint& arm, const cam::Roller& roller, double angle) {
    const double start = std::abs(arm.arm - roller.offset) / std::tan(angle) - arm.travel;
    return std::hypot(start, roller.offset) - roller.radius;
}

core::Findings measure_roller_pressure_angle(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    const cam::Roller& roller = cam.options.roller;
    const auto angle_of = [&](const cam::Contact& c) { return std::abs(cam::pressure_angle(c.arm, roller)); };
    const cam::Contact& worst = worst_contact(cam, angle_of);
    const double angle = angle_of(worst);
    core::Finding f = compare(deg_from_rad(angle), {allowed("required"), allowed("review")});
    f.what =
        fmt::format("largest pressure angle; the rim's side force on the follower is {:.1f} N there", worst.arm.tension * std::tan(angle));
    locate(f, design, worst.path);
    f.suggestion = change(design, "roller.base_radius_mm", up(mm_from_m(base_for(worst.arm, roller, rad_from_deg(f.allowed)))));
    return {f};
}

}  // namespace

Rule roller_pressure_angle() {
    return {"roller.pressure_angle",
            "a follower that jams in its guide",
            "largest angle between the rim's normal and the follower's line on the working arc",
            "R. L. Norton, Cam Design and Manufacturing Handbook: to about 30 deg for a translating follower, 35 for one on a pivoted arm",
            {required(kAtMost, "deg", 35.0), review(kAtMost, "deg", 30.0)},
            measure_roller_pressure_angle,
            works};
}

}  // namespace fusee::checks
