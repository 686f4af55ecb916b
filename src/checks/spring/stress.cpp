#include <fmt/format.h>

#include <cmath>

#include "coil.h"
#include "measure.h"
#include "needs.h"
#include "spring_change.h"

namespace fusee::checks {

namespace {

core::Findings measure_spring_stress(const Design& design, const Allowed& allowed) {
    const spring::BaseSpring& s = design.spring;
    const bool torsion = s.kind == spring::BaseKind::kTorsion;
    const double load = s.rate * largest_state(design);
    // Shear yields at 1/sqrt 3 of tension (von Mises): 46 % of UTS for music wire, 35 % for stainless 302.
    const double share = torsion ? s.stress_share : s.stress_share / std::sqrt(3.0);
    core::Finding f = judge(wire_stress(s, load) / kPaPerMPa, {allowed("required", share * s.tensile_strength / kPaPerMPa)});
    f.what = fmt::format("{} stress of the wire at {:.4g} {}, allowed {:.0f} % of its strength", torsion ? "bending" : "shear", load,
                         torsion ? "Nm" : "N", 100.0 * share);
    f.suggestion = fmt::format("{}, or {}.spring.tensile_strength_MPa = {}", limit_load(design, load * f.allowed / f.measured),
                               name(design), up(f.measured / share));
    return {f};
}

}  // namespace

Rule spring_stress() {
    return {"spring.stress",
            "the base spring's wire yielding",
            "torsion: 32 M K_B/(pi w^3); compression: 8 F D K_W/(pi w^3)",
            "katyspring: 80 % UTS music wire, 60 % 302, K_B; Wahl, shear = share/sqrt 3",
            {required(kAtMost, "MPa", "stress_share of the wire's strength; shear: that share over sqrt 3")},
            measure_spring_stress,
            false,
            {need::kWire, need::kCoil, need::kStrength}};
}

}  // namespace fusee::checks
