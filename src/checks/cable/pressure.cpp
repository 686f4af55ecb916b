#include "fusee/checks/along.h"
#include "means.h"

namespace fusee::checks {

namespace {

constexpr double kConfined = 1.5;  // a material that cannot move aside yields at 1.67 times its strength

core::Findings measure_cable_pressure(const Design& design, const Allowed& allowed) {
    const double d = design.cable.diameter;
    const auto pressure = [d](const cam::Contact& c) { return floor_pressure(c, d); };
    const cam::Contact& worst = worst_contact(design.part.cam, pressure);
    const double bears = bearing_strength(design) / kPaPerMPa;
    const bool own = design.cable.max_pressure > 0.0;
    core::Finding f = own ? compare(pressure(worst) / kPaPerMPa, {allowed("required", bears)})
                          : compare(pressure(worst) / kPaPerMPa, {allowed("required", kConfined * bears), allowed("review", bears)});
    f.what = fmt::format("bearing pressure 2T/(D d) at {:.1f} N on a floor of {:.2f} mm diameter; strength {}", worst.arm.tension,
                         mm_from_m(2.0 * worst.path.rho - d), bearing_origin(design));
    locate(f, design, worst.path, -0.5 * d);
    f.suggestion = fmt::format("a material that allows {} MPa", up(f.measured));
    // D d = (2 rho - d) d = 2T/p: the smaller root; the contour's rho does not depend on d.
    const double rho = worst.path.rho, root = rho * rho - 2.0 * worst.arm.tension / (kPaPerMPa * f.allowed);
    if (root > 0.0) f.suggestion.or_else(change("cable.diameter_mm", up(mm_from_m(rho - std::sqrt(root)))));
    return {f};
}

}  // namespace

Rule cable_pressure() {
    return {"cable.pressure",
            "the cable cutting into the groove's floor",
            "largest 2T/(D d)",
            "2T/(D d) against the strength of the part's material in compression; in a groove the floor yields at 1.5 times that (Johnson: "
            "a line contact at 1.67), so the review limit has a safety of 1.5 (Pugsley: 1.45 for good material and analysis, loads that "
            "springs bound)",
            {required(kAtMost, "MPa", "cable.max_pressure_MPa, or 1.5 times the material's bearing strength (table 5)"),
             review(kAtMost, "MPa", "the material's bearing strength; none beside cable.max_pressure_MPa")},
            measure_cable_pressure,
            works};
}

}  // namespace fusee::checks
