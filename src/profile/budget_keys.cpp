#include "key.h"

namespace fusee::profile {

#define FIELD(member) \
    [](auto& p) -> auto& { return p.member; }

std::vector<Key> budget_keys() {
    const Limits share = within(0, 50);
    return {
        number("budget.runout_mm", kMm, within(0, 10), "of a cam's axis on its shaft; 0 = half of the bore's clearance",
               FIELD(budget.runout)),
        number("budget.guide_mm", kMm, within(0, 100), "of a hole or idler, across its cable; of a follower's line, sideways",
               FIELD(budget.guide)),
        number("budget.guide_deg", kDeg, within(0, 45), "of a parallel exit", FIELD(budget.direction)),
        number("budget.rate_percent", kPercent, share, "of a base spring's rate; Lee Spring, springs3d: 10 for bought springs",
               FIELD(budget.rate)),
        number("budget.measured_rate_percent", kPercent, share, "of a rate whose rate_origin is \"measured\"", FIELD(budget.measured_rate)),
        number("budget.preload_percent", kPercent, share, "of the base spring's state at the law's lowest load", FIELD(budget.preload)),
        number("budget.cable_percent", kPercent, share, "of the cable's diameter", FIELD(budget.cable)),
        number("budget.zero_deg", kDeg, within(0, 45),
               "of the capstan's angle, or a single spring's, against its cams: timing marks, knots, encoder", FIELD(budget.zero)),
        all_of(Key::Of::kJoint, {number("budget.friction_percent", kPercent, share, "of a gear's friction", FIELD(budget.friction))})
            .front(),
    };
}

#undef FIELD

}  // namespace fusee::profile
