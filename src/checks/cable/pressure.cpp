#include <fmt/format.h>

#include <cmath>

#include "fusee/core/units.h"
#include "measure.h"
#include "needs.h"
#include "shape.h"

namespace fusee::checks {

namespace {

core::Findings measure_cable_pressure(const Design& design, const Allowed& allowed) {
    const auto most = allowed.stated("required", design.cable.max_pressure / kPaPerMPa);
    const double d = design.cable.diameter;
    // There is no groove floor where 2 rho <= d: cable.bend_ratio reports it.
    const auto pressure = [d](const cam::Contact& c) {
        return 2.0 * c.path.rho <= d ? 0.0 : 2.0 * c.arm.tension / ((2.0 * c.path.rho - d) * d);
    };
    const cam::Contact& worst = worst_contact(design.part.cam, pressure);
    core::Finding f = judge(pressure(worst) / kPaPerMPa, {*most});
    f.what = fmt::format("bearing pressure 2T/(D d) at {:.1f} N on a floor of {:.2f} mm diameter", worst.arm.tension,
                         core::mm_from_m(2.0 * worst.path.rho - d));
    f.where = where(design, worst.path.psi);
    f.place = place(worst.path, -0.5 * d);
    f.suggestion = fmt::format("a material that allows {} MPa", up(f.measured));
    // D d = (2 rho - d) d = 2T/p: the smaller root; the contour's rho does not depend on d.
    const double rho = worst.path.rho, root = rho * rho - 2.0 * worst.arm.tension / (kPaPerMPa * f.allowed);
    if (root > 0.0) f.suggestion += fmt::format(", or cable.diameter_mm = {}", up(core::mm_from_m(rho - std::sqrt(root))));
    return {f};
}

}  // namespace

Rule cable_pressure() {
    return {"cable.pressure",
            "the cable cutting into the groove's floor",
            "largest 2T/(D d)",
            "2T/(D d) against the part's material: cable.max_pressure_MPa",
            {required(kAtMost, "MPa", "cable.max_pressure_MPa; not judged without it")},
            measure_cable_pressure,
            false,
            {need::material_pressure("required")},
            works};
}

}  // namespace fusee::checks
