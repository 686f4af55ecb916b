#include "means.h"
#include "spring_form.h"

namespace fusee::checks {

namespace {

constexpr double kFewest = 1e4;
constexpr double kUltimateShear = 0.67;  // of the tensile strength

/// Share of the wire's strength that lasts the stated cycles from zero; it falls with their logarithm, constant outside 1e5 to 1e7.
double lasting_share(const spring::BaseSpring& s) {
    const double decades = std::clamp(std::log10(s.cycles) - 5.0, 0.0, 2.0);
    return (s.kind == spring::BaseKind::kTorsion ? 0.53 : 0.36) - 0.03 * decades;
}

/// Goodman's line through the range from zero: the amplitude that lasts at no mean stress [Pa]. With half the share s as amplitude and
/// mean, Sa = (s/2)/(1 - (s/2)/u), u = ultimate share.
double lasting_amplitude(const spring::BaseSpring& s, double ultimate) {
    const double half = 0.5 * lasting_share(s) * spring::tensile_strength(s);
    return half / (1.0 - half / ultimate);
}

/// Unstated cycles count as many.
bool may_tire(const Design& design) { return design.spring.cycles <= 0.0 || design.spring.cycles >= kFewest; }

core::Findings measure_spring_fatigue(const Design& design, const Allowed& allowed) {
    const spring::BaseSpring& s = design.spring;
    const bool torsion = s.kind == spring::BaseKind::kTorsion;
    const double ultimate = (torsion ? 1.0 : kUltimateShear) * spring::tensile_strength(s), lasting = lasting_amplitude(s, ultimate);
    const double low = s.rate * least_state(design), high = s.rate * largest_state(design);
    const double a = 0.5 * spring::wire_stress(s, high - low), m = 0.5 * spring::wire_stress(s, high + low);
    core::Finding f = compare(1.0 / (a / lasting + m / ultimate), {allowed("required")});
    f.what =
        fmt::format("safety of the wire for {:.3g} cycles from {:.4g} to {:.4g} {}: amplitude {:.0f} of {:.0f} MPa, mean {:.0f} of {:.0f}",
                    s.cycles, low, high, torsion ? "Nm" : "N", a / kPaPerMPa, lasting / kPaPerMPa, m / kPaPerMPa, ultimate / kPaPerMPa);
    f.suggestion = stronger_wire(design, spring::tensile_strength(s) * f.allowed / f.measured).or_else("a thicker wire with more turns");
    return {f};
}

}  // namespace

Rule spring_fatigue() {
    return {
        "spring.fatigue",
        "the base spring's wire breaking after many cycles",
        "1/(amplitude/Sa + mean/Su) of the stress between least and largest state; Su the strength, 0.67 of it in shear; Sa on Goodman's "
        "line through the range from zero; from 10,000 cycles on",
        "Shigley: Goodman, Su = 0.67 UTS in shear; range from zero by Associated Spring, music wire, not peened: bending 53 % of UTS at "
        "1e5 cycles, 50 % at 1e6; shear 36, 33 and 30 % at 1e7 (practice)",
        {required(kAtLeast, "", 1.0)},
        measure_spring_fatigue,
        may_tire,
        {need::kWire, need::kCoil, need::kStrength, need::kCycles}};
}

}  // namespace fusee::checks
