#include <fmt/format.h>

#include "fusee/checks/along.h"
#include "fusee/checks/limits.h"
#include "fusee/core/units.h"
#include "measure.h"
#include "shape.h"
#include "spring_change.h"

namespace fusee::checks {

namespace {

core::Findings measure_cable_bend_ratio(const Design& design, const Allowed& allowed) {
    if (design.part.cam.working.empty()) return {};
    const double d = design.cable.diameter;
    const cam::Contact& contact = worst_contact(design.part.cam, [](const cam::Contact& c) { return -c.path.rho; });
    const cam::PathPoint& worst = contact.path;
    const CableLimits& table = cable_limits(design.cable.construction);
    const bool own = design.cable.min_bend_ratio > 0.0;
    const double ratio = bend_ratio(contact, d);
    core::Finding f = own ? judge(ratio, {allowed("required", design.cable.min_bend_ratio)})
                          : judge(ratio, {allowed("required", table.critical), allowed("review", table.recommended)});
    f.what =
        fmt::format("D/d at the cable's sharpest bend, rho {:.3f} mm at a {:.3g} mm cable", core::mm_from_m(worst.rho), core::mm_from_m(d));
    f.where = where(design, worst.psi);
    f.place = place(worst, 0.0);
    const double needed = 0.5 * d * (1.0 + f.allowed);
    if (worst.rho > 0.0)
        f.suggestion =
            change("cable.diameter_mm", down(core::mm_from_m(2.0 * worst.rho / (1.0 + f.allowed))))
                .or_else(scale_arms(design, needed / worst.rho).begun(fmt::format("rho {} mm there: ", up(core::mm_from_m(needed)))));
    else
        f.suggestion = fmt::format("a law or spring whose contour has rho {} mm there", up(core::mm_from_m(needed)));
    f.source = own ? "cable.min_bend_ratio" : table.source;
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
            measure_cable_bend_ratio};
}

}  // namespace fusee::checks
