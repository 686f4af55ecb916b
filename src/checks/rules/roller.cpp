#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_roller_contact_pressure(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    const cam::Roller& roller = cam.options.roller;
    const auto most = allowed.stated("required", roller.max_pressure / kPaPerMPa);
    const auto pressure = [&](const cam::Contact& c) { return cam::contact_pressure(c.arm, cam.options); };
    const cam::Contact& worst = worst_contact(cam, pressure);
    core::Finding f = compare(pressure(worst) / kPaPerMPa, {*most});
    f.what = fmt::format("largest pressure between rim and roller, at a spring force of {:.1f} N", worst.arm.tension);
    locate(f, design, worst.path);
    const double ratio = f.measured / f.allowed;
    f.suggestion = change(design, "roller.width_mm", up(mm_from_m(roller.width * ratio * ratio)));
    return {f};
}

core::Findings measure_roller_lift_off(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    const cam::Contact& least = worst_contact(cam, [](const cam::Contact& c) { return -c.arm.tension; });
    const double most = worst_contact(cam, [](const cam::Contact& c) { return c.arm.tension; }).arm.tension;
    core::Finding f = compare(100.0 * least.arm.tension / most, {allowed("review")});
    f.what = fmt::format("least force of the spring on the follower, {:.2f} N, of {:.1f} N", least.arm.tension, most);
    locate(f, design, least.path);
    f.suggestion = change(design, "spring.preload_mm", up(mm_from_m(0.01 * f.allowed * most / design.spring.rate)));
    return {f};
}

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

core::Findings measure_roller_rim_width(const Design& design, const Allowed& allowed) {
    const solid::PartOptions& options = design.part.options;
    const double width = design.part.cam.options.roller.width, beside = 2.0 * options.groove.rib;
    core::Finding f = compare(mm_from_m(options.rim_width - beside), {allowed("required", mm_from_m(width))});
    f.what = "width of the rim between its two ribs, on which the roller runs";
    f.suggestion = change(design, "roller.rim_width_mm", up(f.allowed + mm_from_m(beside)));
    return {f};
}

core::Findings measure_roller_undercut(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    const cam::Roller& roller = cam.options.roller;
    const cam::Contact& sharpest = worst_contact(cam, [](const cam::Contact& c) { return -c.path.rho; });
    const double pitch = sharpest.path.rho + roller.radius;
    core::Finding f = compare(pitch / roller.radius, {allowed("required"), allowed("review")});
    f.what = fmt::format("least radius of curvature of the roller centre's curve, {:.2f} mm, over the roller's", mm_from_m(pitch));
    locate(f, design, sharpest.path);
    f.suggestion = change(design, "roller.radius_mm", down(mm_from_m(pitch) / f.allowed))
                       .or_else(cam::base_change(roller, up(mm_from_m(roller.base_radius + f.allowed * roller.radius - pitch))));
    return {f};
}

}  // namespace

Rules roller_rules() {
    return {
        {"roller.contact_pressure",
         "a rim that its roller wears or dents",
         "largest pressure of two cylinders along one line, over the working arc",
         "Hertz: sqrt(N E*/(pi width) (1/R_r + 1/rho)), K. L. Johnson, Contact Mechanics, 1985",
         {required(kAtMost, "MPa", "k_pe.roller.max_pressure_MPa; not judged without it and contact_modulus_MPa")},
         measure_roller_contact_pressure,
         works,
         {need::kRollerPressure, need::kContactModulus}},
        {"roller.lift_off",
         "a roller that leaves its rim because the spring force is too small",
         "least force of the spring over the largest",
         "5 %: the follower's own weight and friction in its guide (practice)",
         {review(kAtLeast, "%", 5.0)},
         measure_roller_lift_off,
         works},
        {"roller.pressure_angle",
         "a follower that jams in its guide",
         "largest angle between the rim's normal and the path of the roller's centre on the working arc",
         "R. L. Norton, Cam Design and Manufacturing Handbook: to about 30 deg for a translating follower, 35 for one on a pivoted arm; "
         "beyond 45 deg an arm gets more force along itself than across (practice)",
         {required(kAtMost, "deg", 35.0), review(kAtMost, "deg", 30.0), required(kAtMost, "deg", 45.0, "arm_required"),
          review(kAtMost, "deg", 35.0, "arm_review")},
         measure_roller_pressure_angle,
         works},
        {"roller.rim_width",
         "a roller that hangs over its rim or strikes the flange of a boss",
         "width of the rim less a rib on both sides",
         "geometry: the roller's own width",
         {required(kAtLeast, "mm", "k_pe.roller.width_mm")},
         measure_roller_rim_width},
        {"roller.undercut",
         "a rim with a cusp under its roller",
         "least radius of curvature of the roller centre's curve on the working arc, in roller radii",
         "R. L. Norton, Cam Design and Manufacturing Handbook: at least 2 to 3; at 1 the rim is a cusp; 1.1 (practice)",
         {required(kAtLeast, "roller radii", 1.1), review(kAtLeast, "roller radii", 2.0)},
         measure_roller_undercut,
         works},
    };
}

}  // namespace fusee::checks
