#include "means.h"

namespace fusee::checks {

namespace {

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

}  // namespace

Rule roller_lift_off() {
    return {"roller.lift_off",
            "a roller that leaves its rim because the spring force is too small",
            "least force of the spring over the largest",
            "5 %: the follower's own weight and friction in its guide (practice)",
            {review(kAtLeast, "%", 5.0)},
            measure_roller_lift_off,
            works};
}

}  // namespace fusee::checks
