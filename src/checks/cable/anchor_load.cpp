#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_cable_anchor_load(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    const Cable& cable = design.cable;
    const double friction = cable_limits(cable.construction).friction, held = termination_limits(cable).strength;
    const auto at_end = [&](const cam::Contact& c) { return c.arm.tension * std::exp(-friction * wound_angle(cam, c)); };
    const cam::Contact& worst = worst_contact(cam, at_end);
    if (worst.arm.tension <= 0.0) return {};
    const BreakingLoad load = breaking_load(cable);
    core::Finding f = compare(held * load.newton / at_end(worst), {allowed("required"), allowed("review")});
    f.what =
        fmt::format("safety of the {}, which holds {:.0f} % of the cable's strength: {:.1f} N reach it through {:.0f} deg of wound cable{}",
                    to_string(cable.termination), 100.0 * held, at_end(worst), deg_from_rad(wound_angle(cam, worst)), load.remark(cable));
    f.where = at_anchor(design);
    f.suggestion = change("cable.breaking_load_N", up(f.allowed * at_end(worst) / held));
    return {f};
}

}  // namespace

Rule cable_anchor_load() {
    return {"cable.anchor_load",
            "the cable breaking at its end",
            "least of breaking load x strength of the termination (table 6) / (tension x e^(-friction x angle wound between anchor and "
            "contact))",
            "friction: UHMWPE 0.05, wire 0.1, the least; safety 3, at least 1.5 (practice)",
            {required(kAtLeast, "", 1.5), review(kAtLeast, "", 3.0)},
            measure_cable_anchor_load,
            works};
}

}  // namespace fusee::checks
