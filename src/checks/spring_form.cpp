#include "spring_form.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

bool torsion(const Design& design) { return design.spring.kind == spring::BaseKind::kTorsion; }

core::Suggestion rate(const Design& design, const std::string& value) {
    return change(design, torsion(design) ? "spring.rate_Nm_per_rad" : "spring.rate_N_per_m", value);
}

double in_profile_unit(const Design& design, double preload) { return torsion(design) ? preload : core::mm_from_m(preload); }

std::string preload_key(const Design& design) { return torsion(design) ? "spring.preload_rad" : "spring.preload_mm"; }

/// The largest preload, rounded down, that leaves `gain` below `state`^2; none if the gain alone exceeds it.
core::Suggestion less_preload(const Design& design, double state, double gain) {
    if (state * state <= gain) return {};
    return change(design, preload_key(design), down(in_profile_unit(design, std::sqrt(state * state - gain))));
}

/// state^2 - preload^2 = 2 energy / rate.
double state_gain(const Design& design) { return std::pow(largest_state(design), 2) - std::pow(design.spring.preload, 2); }

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

double largest_state(const Design& design) {
    double largest = design.spring.preload;
    for (const cam::Contact& c : design.part.cam.working) largest = std::max(largest, c.arm.state);
    return largest;
}

double least_state(const Design& design) {
    double least = largest_state(design);
    for (const cam::Contact& c : design.part.cam.working) least = std::min(least, c.arm.state);
    return std::min(least, std::max(design.spring.preload, 0.0));
}

double leg_bend_radius(const spring::BaseSpring& s) { return s.leg_bend_radius > 0.0 ? s.leg_bend_radius : s.wire_diameter; }

double leg_force(const Design& design) { return design.spring.rate * largest_state(design) / design.part.options.features.leg_slot_radius; }

core::Suggestion scale_arms(const Design& design, double factor) {
    const double power = torsion(design) ? 1.0 : -1.0, preload = design.spring.preload * std::pow(factor, -power);
    return rate(design, number(design.spring.rate * std::pow(factor, 2.0 * power), 4))
        .with(key_of(design, preload_key(design)), number(in_profile_unit(design, preload), 4))
        .noted(fmt::format(" (every arm x {:.3g})", factor));
}

core::Suggestion limit_state(const Design& design, double state) {
    const double gain = state_gain(design), start = design.spring.preload, softest = state * state - start * start;
    core::Suggestion changes = less_preload(design, state, gain);
    if (softest > 0.0) changes.or_else(rate(design, up(design.spring.rate * gain / softest)));
    // Both together keep the cam's shape: with rate and preload of `scale_arms` every state is scaled too.
    const double share = state / largest_state(design);
    return changes.or_else(scale_arms(design, torsion(design) ? 1.0 / share : share));
}

core::Suggestion limit_load(const Design& design, double load) {
    const double gain = state_gain(design), start = design.spring.preload, state = load / design.spring.rate;
    const double energy = 0.5 * design.spring.rate * gain;  // load^2 = (rate preload)^2 + 2 rate energy
    const double softer =
        start > 0.0 ? (std::sqrt(energy * energy + std::pow(start * load, 2)) - energy) / (start * start) : load * load / (2.0 * energy);
    return less_preload(design, state, gain).or_else(rate(design, down(softer)));
}

}  // namespace fusee::checks
