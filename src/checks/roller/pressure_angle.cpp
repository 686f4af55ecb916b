#include "means.h"

namespace fusee::checks {

namespace {

/// The base radius for a pressure angle of `angle` at this arm [m]; of a follower's arm the first of a series, at most 100 times its own.
double base_for(const cam::ArmPoint& arm, cam::CamOptions options, double angle) {
    constexpr double kGrowth = 1.01;
    constexpr int kSteps = 463;
    const cam::Roller roller = options.roller;
    if (roller.follower == cam::FollowerKind::kSlide) {
        const double start = std::abs(arm.arm - roller.offset) / std::tan(angle) - arm.travel;
        return std::hypot(start, roller.offset) - roller.radius;
    }
    for (int i = 1; i <= kSteps && std::abs(cam::pressure_angle(arm, options)) > angle; ++i)
        options.roller = cam::with_base(roller, roller.base_radius * std::pow(kGrowth, i));
    return options.roller.base_radius;
}

core::Findings measure_roller_pressure_angle(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    const auto angle_of = [&](const cam::Contact& c) { return std::abs(cam::pressure_angle(c.arm, cam.options)); };
    const cam::Contact& worst = worst_contact(cam, angle_of);
    const double angle = angle_of(worst);
    const bool slide = cam.options.roller.follower == cam::FollowerKind::kSlide;
    core::Finding f =
        compare(deg_from_rad(angle), {allowed(slide ? "required" : "arm_required"), allowed(slide ? "review" : "arm_review")});
    f.what =
        fmt::format("largest pressure angle; the rim's {} is {:.1f} N there", slide ? "side force on the follower" : "force along the arm",
                    cam::spring_ratio(worst.arm, cam.options) * worst.arm.tension * std::tan(angle));
    locate(f, design, worst.path);
    const double base = base_for(worst.arm, cam.options, rad_from_deg(f.allowed));
    f.suggestion = cam::base_change(cam.options.roller, up(mm_from_m(base)));
    return {f};
}

}  // namespace

Rule roller_pressure_angle() {
    return {"roller.pressure_angle",
            "a follower that jams in its guide",
            "largest angle between the rim's normal and the path of the roller's centre on the working arc",
            "R. L. Norton, Cam Design and Manufacturing Handbook: to about 30 deg for a translating follower, 35 for one on a pivoted arm; "
            "beyond 45 deg an arm gets more force along itself than across (practice)",
            {required(kAtMost, "deg", 35.0), review(kAtMost, "deg", 30.0), required(kAtMost, "deg", 45.0, "arm_required"),
             review(kAtMost, "deg", 35.0, "arm_review")},
            measure_roller_pressure_angle,
            works};
}

}  // namespace fusee::checks
