#include "means.h"
#include "spring_form.h"

namespace fusee::checks {

namespace {

core::Findings measure_spring_stress(const Design& design, const Allowed& allowed) {
    const spring::BaseSpring& s = design.spring;
    const bool torsion = s.kind == spring::BaseKind::kTorsion;
    const double load = s.rate * largest_state(design);
    const double share = spring::allowed_share(s);
    core::Finding f =
        compare(spring::wire_stress(s, load) / kPaPerMPa, {allowed("required", share * spring::tensile_strength(s) / kPaPerMPa)});
    f.what = fmt::format("{} stress of the wire at {:.4g} {}, allowed {:.0f} % of its strength", torsion ? "bending" : "shear", load,
                         torsion ? "Nm" : "N", 100.0 * share);
    f.suggestion = limit_load(design, load * f.allowed / f.measured).or_else(stronger_wire(design, f.measured / share * kPaPerMPa));
    return {f};
}

}  // namespace

Rule spring_stress() {
    return {
        "spring.stress",
        "the base spring's wire yielding",
        "torsion: 32 M q/(pi d^3), q = (w + 0.07)/(w - 0.75); compression: 8 F D K_W/(pi d^3)",
        "EN 13906-3: 0.7 of the strength, q; Wahl, in shear 0.8/sqrt 3; strength: stated, or EN 10270-1 by class",
        {required(kAtMost, "MPa", "stress_share of the wire's strength, 0.7 by default; shear: that share over sqrt 3, 0.46 by default")},
        measure_spring_stress,
        nullptr,
        {need::kWire, need::kCoil, need::kStrength}};
}

}  // namespace fusee::checks
