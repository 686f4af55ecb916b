#include "spring_change.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"
#include "measure.h"

namespace fusee::checks {

namespace {

bool torsion(const Design& design) { return design.spring.kind == spring::BaseKind::kTorsion; }

std::string rate(const Design& design, const std::string& value) {
    return fmt::format("{}.spring.{} = {}", name(design), torsion(design) ? "rate_Nm_per_rad" : "rate_N_per_m", value);
}

double in_profile_unit(const Design& design, double preload) { return torsion(design) ? preload : core::mm_from_m(preload); }

std::string preload(const Design& design, const std::string& value) {
    return fmt::format("{}.spring.{} = {}", name(design), torsion(design) ? "preload_rad" : "preload_mm", value);
}

/// state^2 - preload^2 = 2 energy / rate.
double state_gain(const Design& design) { return std::pow(largest_state(design), 2) - std::pow(design.spring.preload, 2); }

std::string joined(const std::string& a, const std::string& b) { return a.empty() || b.empty() ? a + b : a + ", or " + b; }

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

std::string scale_arms(const Design& design, double factor) {
    const double power = torsion(design) ? 1.0 : -1.0;
    return fmt::format(
        "{} with {} (every arm x {:.3g})", rate(design, fmt::format("{:.4g}", design.spring.rate * std::pow(factor, 2.0 * power))),
        preload(design, fmt::format("{:.4g}", in_profile_unit(design, design.spring.preload * std::pow(factor, -power)))), factor);
}

std::string limit_state(const Design& design, double state) {
    const double gain = state_gain(design), start = design.spring.preload, softest = state * state - start * start;
    const std::string less = state * state > gain ? preload(design, down(in_profile_unit(design, std::sqrt(state * state - gain)))) : "";
    const std::string stiffer = softest > 0.0 ? rate(design, up(design.spring.rate * gain / softest)) : "";
    // Both together keep the cam's shape: with rate and preload of `scale_arms` every state is scaled too.
    const double share = state / largest_state(design);
    return joined(joined(less, stiffer), scale_arms(design, torsion(design) ? 1.0 / share : share));
}

std::string limit_load(const Design& design, double load) {
    const double gain = state_gain(design), start = design.spring.preload, state = load / design.spring.rate;
    const double energy = 0.5 * design.spring.rate * gain;  // load^2 = (rate preload)^2 + 2 rate energy
    const std::string less = state * state > gain ? preload(design, down(in_profile_unit(design, std::sqrt(state * state - gain)))) : "";
    const double softer =
        start > 0.0 ? (std::sqrt(energy * energy + std::pow(start * load, 2)) - energy) / (start * start) : load * load / (2.0 * energy);
    return joined(less, rate(design, down(softer)));
}

}  // namespace fusee::checks
