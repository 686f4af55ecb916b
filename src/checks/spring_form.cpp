#include "spring_form.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"
#include "fusee/spring/coil.h"
#include "measure.h"

namespace fusee::checks {

namespace {

using spring::BaseSpring;

bool within(double value, double low, double high) { return value >= low && value <= high; }

bool can_be_wound(const BaseSpring& s) {
    return within(spring::spring_index(s), kLeastIndex, kMostIndex) && s.active_coils >= kFewestCoils &&
           within(core::mm_from_m(s.wire_diameter), kThinnest_mm, kThickest_mm);
}

BaseSpring with_turns(BaseSpring s) {
    s.active_coils = spring::turns_for_rate(s);
    return s;
}
BaseSpring with_wire(BaseSpring s) {
    s.wire_diameter = spring::wire_for_rate(s);
    return s;
}

/// Wire and coil in the proportion `index` for which `s` has its rate: the rate grows with the third power of the size (torsion) or the
/// first.
BaseSpring scaled_to_rate(BaseSpring s, double index) {
    s.coil_diameter = index * s.wire_diameter;
    const double power = s.kind == spring::BaseKind::kTorsion ? 3.0 : 1.0, size = std::pow(s.rate / spring::rate_of_coils(s), 1.0 / power);
    s.wire_diameter *= size, s.coil_diameter *= size;
    return s;
}

/// The coils nearest to the stated ones: their index and turns if the wire allows it, else the tightest or the loosest index.
core::Suggestion nearest_form(const Design& design) {
    BaseSpring s = design.spring;
    s.active_coils = std::max(s.active_coils, kFewestCoils);
    for (const double index : {std::clamp(spring::spring_index(s), kLeastIndex, kMostIndex), kLeastIndex, kMostIndex}) {
        const BaseSpring form = scaled_to_rate(s, index);
        if (within(core::mm_from_m(form.wire_diameter), kThinnest_mm, kThickest_mm))
            return change(design, "spring.wire_mm", number(core::mm_from_m(form.wire_diameter), 4))
                .with(key_of(design, "spring.coil_mm"), number(core::mm_from_m(form.coil_diameter), 4))
                .with(key_of(design, "spring.active_coils"), number(form.active_coils, 4))
                .begun("neither other turns nor another wire in these coils can be wound; ");
    }
    return fmt::format("no wound spring of {:.4g} turns has this rate: index {:g} to {:g}, wire {:g} to {:g} mm", s.active_coils,
                       kLeastIndex, kMostIndex, kThinnest_mm, kThickest_mm);
}

}  // namespace

core::Suggestion form_for_rate(const Design& design) {
    const BaseSpring &s = design.spring, turns = with_turns(s), wire = with_wire(s);
    core::Suggestion changes;
    if (can_be_wound(turns)) changes.or_else(change(design, "spring.active_coils", number(turns.active_coils, 4)));
    if (can_be_wound(wire)) changes.or_else(change(design, "spring.wire_mm", number(core::mm_from_m(wire.wire_diameter), 4)));
    if (changes.empty()) changes = nearest_form(design);
    const char* rate = s.kind == spring::BaseKind::kTorsion ? "spring.rate_Nm_per_rad" : "spring.rate_N_per_m";
    if (can_be_wound(s)) changes.or_else(change(design, rate, number(spring::rate_of_coils(s), 4)).noted(", which the stated coils have"));
    return changes;
}

core::Suggestion stronger_wire(const Design& design, double strength) {
    constexpr double kPascal = 1e6;
    const double wire = design.spring.wire_diameter, strongest = spring::strength_of(spring::WireClass::kDh, wire);
    if (strength <= strongest) return change(design, "spring.tensile_strength_MPa", up(strength / kPascal));
    return fmt::format("no stronger wire: it would need {:.0f} MPa, and patented wire of {:.3g} mm has {:.0f} MPa at most (EN 10270-1 DH)",
                       strength / kPascal, core::mm_from_m(wire), strongest / kPascal);
}

}  // namespace fusee::checks
