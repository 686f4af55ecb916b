#include "means.h"

namespace fusee::checks {

namespace {

constexpr double kScatter = 0.1;

core::Findings measure_spring_rate_scatter(const Design& design, const Allowed& allowed) {
    const bool torsion = design.spring.kind == spring::BaseKind::kTorsion;
    const double unit = torsion ? 1.0 : mm_from_m(1.0), state = unit * largest_state(design);
    const auto most = allowed.stated(torsion ? "angle_review" : "travel_review", unit * design.spring.max_state);
    if (state > most->value()) return {};  // already beyond its range: spring.torsion_angle and spring.travel report it
    core::Finding f = compare(state / (1.0 - kScatter), {*most});
    f.what = fmt::format("largest {} of a base spring whose rate is {:.0f} % low, preload trimmed", torsion ? "winding" : "compression",
                         100.0 * kScatter);
    f.suggestion = limit_state(design, (1.0 - kScatter) * f.allowed / unit).or_else("the measured rate in the profile");
    return {f};
}

}  // namespace

Rule spring_rate_scatter() {
    return {"spring.rate_scatter",
            "a spring softer than specified, beyond what a preload trim corrects",
            "largest state of a spring whose rate is 10 % low, trimmed to the same load",
            "Lee Spring, springs3d: rate and torque of stock springs to 10 %; EN 15800 tolerates loads and dimensions, not the rate",
            {review(kAtMost, "rad", "spring.max_angle_rad; not judged without it", "angle_review"),
             review(kAtMost, "mm", "spring.max_travel_mm; not judged without it", "travel_review")},
            measure_spring_rate_scatter,
            nullptr,
            {need::kScatterAngle, need::kScatterTravel}};
}

}  // namespace fusee::checks
