#include <array>
#include <string_view>

#include "fusee/checks/along.h"
#include "means.h"

namespace fusee::checks {

namespace {

constexpr double kConfined = 1.5;  // a material that cannot move aside yields at 1.67 times its strength

/// Pressure under which a wire rope does not wear the groove of a steel sheave [MPa].
struct Sheave {
    std::string_view construction;
    double on_steel;
};
// Of 6x7, 6x19 and 6x37: 550, 900 and 1075 psi.
constexpr std::array kSheaves{Sheave{"7x7", 3.8}, Sheave{"7x19", 6.2}, Sheave{"7x49", 7.4}};
constexpr double kCastIron = 480.0 / 900.0;  // of that under 6x19; the tables have no aluminium

/// [MPa]; infinity where no table that was read has the pair: any fibre, and wire on plastic.
double wear_limit(const Cable& cable, std::string_view material) {
    for (const Sheave& sheave : kSheaves) {
        if (sheave.construction != cable.construction) continue;
        if (material == "steel") return sheave.on_steel;
        if (material == "aluminium") return kCastIron * sheave.on_steel;
    }
    return INFINITY;
}

core::Findings measure_cable_pressure(const Design& design, const Allowed& allowed) {
    const double d = design.cable.diameter;
    const auto pressure = [d](const cam::Contact& c) { return floor_pressure(c, d); };
    const cam::Contact& worst = worst_contact(design.part.cam, pressure);
    const double bears = bearing_strength(design) / kPaPerMPa;
    const bool own = design.cable.max_pressure > 0.0;
    const double wear = own ? INFINITY : wear_limit(design.cable, material_of(design.process).name);
    core::Finding f =
        own ? compare(pressure(worst) / kPaPerMPa, {allowed("required", bears)})
            : compare(pressure(worst) / kPaPerMPa, {allowed("required", kConfined * bears), allowed("review", std::min(bears, wear))});
    f.what = fmt::format("bearing pressure 2T/(D d) at {:.1f} N on a floor of {:.2f} mm diameter; strength {}", worst.arm.tension,
                         mm_from_m(2.0 * worst.path.rho - d), bearing_origin(design));
    if (wear < bears) f.what += fmt::format("; {} wears its groove from {:.2g} MPa on", design.cable.construction, wear);
    locate(f, design, worst.path, -0.5 * d);
    f.suggestion = fmt::format("a material that allows {} MPa", up(f.measured));
    // D d = (2 rho - d) d = 2T/p: the smaller root; the contour's rho does not depend on d.
    const double rho = worst.path.rho, root = rho * rho - 2.0 * worst.arm.tension / (kPaPerMPa * f.allowed);
    if (root > 0.0) f.suggestion.or_else(change("cable.diameter_mm", up(mm_from_m(rho - std::sqrt(root)))));
    return {f};
}

}  // namespace

Rule cable_pressure() {
    return {
        "cable.pressure",
        "the cable cutting into the groove's floor",
        "largest 2T/(D d)",
        "2T/(D d) against the strength of the part's material in compression (oceanmax: sheaves of plastic yield above it); in a groove "
        "the floor yields at 1.5 times that (Johnson: a line contact at 1.67), so the review limit has a safety of 1.5 (Pugsley: 1.45 "
        "for good material and analysis, loads that springs bound). Wire wears metal long before: cast steel of 160 HB bears 3.8, 6.2 "
        "and 7.4 MPa under 6x7, 6x19 and 6x37 (Wire Rope Users Manual, at eng-tips), cast iron 0.53 of that under 6x19 (Handbook of "
        "Rigging, by K3NA), which is taken for aluminium",
        {required(kAtMost, "MPa", "cable.max_pressure_MPa, or 1.5 times the material's bearing strength (table 5)"),
         review(kAtMost, "MPa",
                "the material's bearing strength; under 7x7, 7x19, 7x49 on steel 3.8, 6.2, 7.4 MPa, on aluminium 2, 3.3, 3.9 MPa; none "
                "beside cable.max_pressure_MPa")},
        measure_cable_pressure,
        works};
}

}  // namespace fusee::checks
