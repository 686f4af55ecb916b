#include "spring_change.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"
#include "measure.h"

namespace fusee::checks {

namespace {

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
