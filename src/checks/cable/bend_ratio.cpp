#include "fusee/checks/along.h"
#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_cable_bend_ratio(const Design& design, const Allowed& allowed) {
    const double d = design.cable.diameter;
    const cam::Contact& contact = worst_contact(design.part.cam, [](const cam::Contact& c) { return -c.path.rho; });
    const cam::PathPoint& worst = contact.path;
    core::Finding f = judge_bend(bend_ratio(contact, d), design, allowed);
    f.what = fmt::format("D/d at the cable's sharpest bend, rho {:.3f} mm at a {:.3g} mm cable", mm_from_m(worst.rho), mm_from_m(d));
    locate(f, design, worst);
    const double needed = 0.5 * d * (1.0 + f.allowed);
    if (worst.rho > 0.0)
        f.suggestion = change("cable.diameter_mm", down(mm_from_m(2.0 * worst.rho / (1.0 + f.allowed))))
                           .or_else(scale_arms(design, needed / worst.rho).begun(fmt::format("rho {} mm there: ", up(mm_from_m(needed)))));
    else
        f.suggestion = fmt::format("a law or spring whose contour has rho {} mm there", up(mm_from_m(needed)));
    return {f};
}

}  // namespace

Rule cable_bend_ratio() {
    return {"cable.bend_ratio",
            "the cable bent so sharply that it wears out",
            "D/d = (2 rho - d)/d at the sharpest working bend",
            "by construction: Sava, Strandcore, The Complete Rigger's Apprentice",
            {required(kAtLeast, "", "the construction's critical figure (table 1), or cable.min_bend_ratio"),
             review(kAtLeast, "", "the construction's recommended figure (table 1); none beside cable.min_bend_ratio")},
            measure_cable_bend_ratio,
            works};
}

}  // namespace fusee::checks
