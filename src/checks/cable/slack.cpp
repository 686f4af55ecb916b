#include "means.h"

namespace fusee::checks {

namespace {

constexpr double kLeast = 1e-3;  // of the largest tension: below, no start torque follows from it

core::Findings measure_cable_slack(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    const cam::Contact& least = worst_contact(cam, [](const cam::Contact& c) { return -c.arm.tension; });
    const double most = worst_contact(cam, [](const cam::Contact& c) { return c.arm.tension; }).arm.tension;
    if (most <= 0.0) return {};
    core::Finding f = compare(100.0 * least.arm.tension / most, {allowed("review")});
    f.what = fmt::format("least tension, {:.2f} N, of {:.1f} N", least.arm.tension, most);
    locate(f, design, least.path);
    const double wanted = 0.01 * f.allowed * most;
    if (design.spring.kind == spring::BaseKind::kCompression)
        f.suggestion = change(design, "spring.preload_mm", up(mm_from_m(wanted / design.spring.rate)));
    else
        f.suggestion = change("law.start_torque_Nm", up(least.arm.tau * wanted / std::max(least.arm.tension, kLeast * most)))
                           .noted(fmt::format(": {} N", up(wanted)));
    return {f};
}

}  // namespace

Rule cable_slack() {
    return {"cable.slack",
            "a cable that goes slack and leaves its groove",
            "least tension over the largest",
            "1 % (practice)",
            {review(kAtLeast, "%", 1.0)},
            measure_cable_slack,
            works};
}

}  // namespace fusee::checks
