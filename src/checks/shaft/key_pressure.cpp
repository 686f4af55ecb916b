#include "means.h"

namespace fusee::checks {

namespace {

constexpr double kOfYield = 0.9;  // DIN 6892, method C

/// What the key may press with [MPa]: a metal has the standard's reserve, a plastic and a stated pressure have none.
double permissible(const Design& design) {
    const Material material = material_of(design.process);
    const bool metal = material.bearing <= material.strength;
    return (metal && design.cable.max_pressure <= 0.0 ? kOfYield : 1.0) * bearing_strength(design) / kPaPerMPa;
}

bool is_keyed(const Design& design) {
    const solid::HubOptions& hub = design.part.options.hub;
    return works(design) && hub.lock == solid::HubLock::kKeyway && hub.key_depth * bore_length(design.part) > 0.0;
}

/// The next larger shaft whose key has so much of a side times bore [m^2].
core::Suggestion larger_shaft(const Design& design, double needed) {
    double bore = mm_from_m(design.part.options.hub.bore_diameter);
    while (const auto next = shaft_sizes().at_least(1.01 * bore)) {
        bore = *next;
        const KeySize* size = key_size(m_from_mm(bore));
        if (size == nullptr || m_from_mm(bore) * size->hub_side() < needed) continue;
        return change(design, "hub.bore_mm", number(bore))
            .with(key_of(design, "hub.key_width_mm"), number(mm_from_m(size->width)))
            .with(key_of(design, "hub.key_depth_mm"), number(mm_from_m(size->hub_depth)));
    }
    return {};
}

core::Findings measure_shaft_key_pressure(const Design& design, const Allowed& allowed) {
    const solid::HubOptions& hub = design.part.options.hub;
    const double length = bore_length(design.part);
    const KeySize* size = key_size(hub.bore_diameter);
    const double side = size ? std::min(size->hub_side(), hub.key_depth) : hub.key_depth;
    const double torque = largest_torque(design.part.cam);
    const double bears = bearing_strength(design) / kPaPerMPa;
    core::Finding f = compare(2.0 * torque / (hub.bore_diameter * side * length) / kPaPerMPa, {allowed("review", permissible(design))});
    f.what = fmt::format("pressure of the key on {:.3g} mm of its keyway at {:.3g} Nm; the strength {}, {:.3g} MPa, is {:.2f} times that",
                         mm_from_m(side), torque, bearing_origin(design), bears, bears / f.measured);
    f.suggestion = change(design, "hub.boss_height_mm", up(mm_from_m(hub.boss_height + length * (f.measured / f.allowed - 1.0))));
    f.suggestion.or_else(larger_shaft(design, hub.bore_diameter * side * f.measured / f.allowed));
    return {f};
}

}  // namespace

Rule shaft_key_pressure() {
    return {
        "shaft.key_pressure",
        "a key that crushes its keyway",
        "keyway: 2 M/(bore (h - t1) length) at the largest torque",
        "DIN 6885-1: the key stands h - t1 in the hub. In a metal it may press with 0.9 of the yield strength (DIN 6892 method C, by "
        "hanslhansl/engineering-standards-library): a reserve of 1.11. The standard is for metals: the limit of a plastic is its strength "
        "in compression, and the finding states what is left to it; pressure does not tire a hub (tribology-abc), and the springs bound "
        "the torque. Others want a third where loads are not known (Mott), 21 MPa in a laminate (Tufnol): [[limits]] states yours. The "
        "whole length bears",
        {review(kAtMost, "MPa", "cable.max_pressure_MPa, or the material's bearing strength (table 5), of metals 0.9 of it")},
        measure_shaft_key_pressure,
        is_keyed};
}

}  // namespace fusee::checks
