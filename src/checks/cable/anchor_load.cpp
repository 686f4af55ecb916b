#include <fmt/format.h>

#include <cmath>

#include "fusee/core/units.h"
#include "measure.h"
#include "needs.h"
#include "shape.h"

namespace fusee::checks {

namespace {

constexpr double kFriction = 0.1;  // between cable and floor
constexpr double kKnot = 0.5;      // share of the cable's strength that a knot leaves

core::Findings measure_cable_anchor_load(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    const auto at_knot = [&cam](const cam::Contact& c) { return c.arm.tension * std::exp(-kFriction * wound_angle(cam, c)); };
    const cam::Contact& worst = worst_contact(cam, at_knot);
    if (worst.arm.tension <= 0.0) return {};
    core::Finding f = judge(kKnot * design.cable.breaking_load / at_knot(worst), {allowed("required"), allowed("review")});
    f.what = fmt::format("safety of the knot: {:.1f} N reach it through {:.0f} deg of wound cable", at_knot(worst),
                         core::deg_from_rad(wound_angle(cam, worst)));
    f.where = where(design, cam.anchor_psi);
    f.suggestion = fmt::format("cable.breaking_load_N = {}", up(f.allowed * at_knot(worst) / kKnot));
    return {f};
}

}  // namespace

Rule cable_anchor_load() {
    return {"cable.anchor_load",
            "the cable breaking at its knot",
            "least of breaking load x 0.5 / (tension x e^(-0.1 angle wound between anchor and contact))",
            "a knot leaves half the strength, friction 0.1, safety 3, at least 1.5 (practice)",
            {required(kAtLeast, "", 1.5), review(kAtLeast, "", 3.0)},
            measure_cable_anchor_load,
            false,
            {need::kBreakingLoad},
            works};
}

}  // namespace fusee::checks
