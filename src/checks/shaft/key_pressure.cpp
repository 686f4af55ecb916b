#include "means.h"

namespace fusee::checks {

namespace {

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
    core::Finding f =
        compare(2.0 * torque / (hub.bore_diameter * side * length) / kPaPerMPa, {allowed("review", bearing_strength(design) / kPaPerMPa)});
    f.what = fmt::format("pressure of the key on {:.3g} mm of its keyway at {:.3g} Nm; strength {}", mm_from_m(side), torque,
                         bearing_origin(design));
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
        "DIN 6885-1: the key stands h - t1 in the hub. The limit is the strength of the part's material in compression, without a "
        "reserve: pressure does not tire a hub (tribology-abc), and the springs bound the torque. Sources contradict one another on a "
        "reserve: 0.9 of the yield strength (DIN 6892 method C, metals only, by hanslhansl/engineering-standards-library), a third where "
        "loads are not known (Mott), 21 MPa in a laminate (Tufnol). [[limits]] states yours",
        {review(kAtMost, "MPa", "cable.max_pressure_MPa, or the material's bearing strength (table 5)")},
        measure_shaft_key_pressure,
        is_keyed};
}

}  // namespace fusee::checks
