#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "coil.h"
#include "measure.h"
#include "needs.h"
#include "spring_change.h"

namespace fusee::checks {

namespace {

constexpr double kFewest = 1e4;

/// Share of the wire's strength that lasts the stated cycles; it falls with their logarithm, constant outside 1e5 to 1e7.
double lasting_share(const spring::BaseSpring& s) {
    const double decades = std::clamp(std::log10(s.cycles) - 5.0, 0.0, 2.0);
    return (s.kind == spring::BaseKind::kTorsion ? 0.53 : 0.36) - 0.03 * decades;
}

/// Unstated cycles count as many.
bool may_tire(const Design& design) { return design.spring.cycles <= 0.0 || design.spring.cycles >= kFewest; }

core::Findings measure_spring_fatigue(const Design& design, const Allowed& allowed) {
    const spring::BaseSpring& s = design.spring;
    const double share = lasting_share(s), load = s.rate * largest_state(design);
    core::Finding f = judge(wire_stress(s, load) / kPaPerMPa, {allowed("required", share * s.tensile_strength / kPaPerMPa)});
    f.what = fmt::format("stress of the wire at {:.4g} {}; {:.0f} % of its strength last {:.3g} cycles", load,
                         s.kind == spring::BaseKind::kTorsion ? "Nm" : "N", 100.0 * share, s.cycles);
    f.suggestion = fmt::format("{}, or {}.spring.tensile_strength_MPa = {}", limit_load(design, load * f.allowed / f.measured),
                               name(design), up(f.measured / share));
    return {f};
}

}  // namespace

Rule spring_fatigue() {
    return {"spring.fatigue",
            "the base spring's wire breaking after many cycles",
            "stress at the largest state, loaded from zero; from 10,000 cycles on",
            "Associated Spring, music wire, not peened: bending 53 % of UTS at 1e5 cycles, 50 % at 1e6; shear 36, 33 and 30 % at 1e7 "
            "(practice)",
            {required(kAtMost, "MPa", "the wire's strength times its share at spring.cycles")},
            measure_spring_fatigue,
            false,
            {need::kWire, need::kCoil, need::kStrength, need::kCycles},
            may_tire};
}

}  // namespace fusee::checks
