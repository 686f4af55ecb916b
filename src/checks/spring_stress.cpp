#include <fmt/format.h>

#include <cmath>

#include "fusee/core/units.h"
#include "measure.h"
#include "rules.h"
#include "spring_change.h"

namespace fusee::checks {

namespace {

constexpr double kMega = 1e6;

/// Bending stress at the inside of a torsion spring's coil: 32 M K_B/(pi w^3), K_B = (4C^2 - C - 1)/(4C(C - 1)), C = D/w.
double bending_stress(const spring::BaseSpring& s, double torque) {
    const double c = s.coil_diameter / s.wire_diameter;
    return 32.0 * torque * (4.0 * c * c - c - 1.0) / (4.0 * c * (c - 1.0)) / (core::kPi * std::pow(s.wire_diameter, 3));
}

/// Shear stress at the inside of a compression spring's coil: 8 F D K_W/(pi w^3), K_W = (4C - 1)/(4C - 4) + 0.615/C (Wahl).
double shear_stress(const spring::BaseSpring& s, double force) {
    const double c = s.coil_diameter / s.wire_diameter;
    return 8.0 * force * s.coil_diameter * ((4.0 * c - 1.0) / (4.0 * c - 4.0) + 0.615 / c) / (core::kPi * std::pow(s.wire_diameter, 3));
}

core::Findings run(const Design& design) {
    const spring::BaseSpring& s = design.spring;
    if (s.wire_diameter <= 0.0 || s.coil_diameter <= s.wire_diameter || s.tensile_strength <= 0.0) return {};
    const bool torsion = s.kind == spring::BaseKind::kTorsion;
    const double load = s.rate * largest_state(design);
    // Shear yields at 1/sqrt 3 of tension (von Mises): 46 % of UTS for music wire, 35 % for stainless 302.
    const double share = torsion ? s.stress_share : s.stress_share / std::sqrt(3.0);
    core::Finding f =
        at_most((torsion ? bending_stress(s, load) : shear_stress(s, load)) / kMega, {share * s.tensile_strength / kMega, {}}, "MPa");
    f.what = fmt::format("{} stress of the wire at {:.4g} {}, allowed {:.0f} % of its strength", torsion ? "bending" : "shear", load,
                         torsion ? "Nm" : "N", 100.0 * share);
    f.suggestion = fmt::format("{}, or {}.spring.tensile_strength_MPa = {}", limit_load(design, load * f.allowed / f.measured),
                               name(design), up(f.measured / share));
    return {f};
}

}  // namespace

Rule spring_stress() {
    return {"spring.stress", "the base spring's wire yielding",
            "katyspring: 80 % UTS music wire, 60 % 302, K_B; Wahl, shear = share/sqrt 3", run};
}

}  // namespace fusee::checks
