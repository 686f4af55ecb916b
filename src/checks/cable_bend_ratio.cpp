#include <fmt/format.h>

#include "fusee/checks/limits.h"
#include "fusee/core/units.h"
#include "measure.h"
#include "rules.h"
#include "shape.h"
#include "spring_change.h"

namespace fusee::checks {

namespace {

core::Findings run(const Design& design) {
    if (design.part.cam.working.empty()) return {};
    const double d = design.cable.diameter;
    const cam::PathPoint& worst = worst_contact(design.part.cam, [](const cam::Contact& c) { return -c.path.rho; }).path;
    const CableLimits& table = cable_limits(design.cable.construction);
    const bool own = design.cable.min_bend_ratio > 0.0;
    const Limits limits = own ? Limits{design.cable.min_bend_ratio, {}} : Limits{table.critical, table.recommended};
    core::Finding f = at_least((2.0 * worst.rho - d) / d, limits, "");
    f.what =
        fmt::format("D/d at the cable's sharpest bend, rho {:.3f} mm at a {:.3g} mm cable", core::mm_from_m(worst.rho), core::mm_from_m(d));
    f.where = where(design, worst.psi);
    f.place = place(worst, 0.0);
    const double needed = 0.5 * d * (1.0 + f.allowed);
    if (worst.rho > 0.0)
        f.suggestion =
            fmt::format("cable.diameter_mm = {}, or rho {} mm there: {}", down(core::mm_from_m(2.0 * worst.rho / (1.0 + f.allowed))),
                        up(core::mm_from_m(needed)), scale_arms(design, needed / worst.rho));
    else
        f.suggestion = fmt::format("a law or spring whose contour has rho {} mm there", up(core::mm_from_m(needed)));
    f.source = own ? "cable.min_bend_ratio" : table.source;
    return {f};
}

}  // namespace

Rule cable_bend_ratio() {
    return {"cable.bend_ratio", "the cable bent so sharply that it wears out",
            "by construction: Sava, Strandcore, The Complete Rigger's Apprentice", run};
}

}  // namespace fusee::checks
