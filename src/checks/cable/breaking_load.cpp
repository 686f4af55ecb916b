#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_cable_breaking_load(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    const double d = design.cable.diameter;
    const auto left = [&](const cam::Contact& c) { return strength_left(design.cable.construction, (2.0 * c.path.rho - d) / d); };
    const cam::Contact& worst = worst_contact(cam, [&](const cam::Contact& c) { return c.arm.tension / left(c); });
    if (worst.arm.tension <= 0.0) return {};
    const BreakingLoad load = breaking_load(design.cable);
    core::Finding f = compare(load.newton * left(worst) / worst.arm.tension, {allowed("required"), allowed("review")});
    f.what = fmt::format("safety against breaking at {:.1f} N, with {:.0f} % of the strength left at this bend{}", worst.arm.tension,
                         100.0 * left(worst), load.remark(design.cable));
    locate(f, design, worst.path);
    f.suggestion = change("cable.breaking_load_N", up(f.allowed * worst.arm.tension / left(worst)));
    return {f};
}

}  // namespace

Rule cable_breaking_load() {
    return {"cable.breaking_load",
            "the cable breaking under its largest tension",
            "least of breaking load x strength left at D/d (table 2) / tension",
            "safety 5, at least 3 (practice) for running cable; strength left at D/d: Sava",
            {required(kAtLeast, "", 3.0), review(kAtLeast, "", 5.0)},
            measure_cable_breaking_load,
            works};
}

}  // namespace fusee::checks
