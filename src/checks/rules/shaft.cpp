#include "fusee/checks/thread.h"
#include "fusee/solid/companions.h"
#include "means.h"

namespace fusee::checks {

namespace {

bool has_blind_keyway(const Design& design) {
    const solid::HubOptions& hub = design.part.options.hub;
    return is_milled(design) && hub.kind == solid::HubKind::kOverhung && hub.lock == solid::HubLock::kKeyway;
}

core::Findings measure_shaft_blind_keyway(const Design& design, const Allowed& allowed) {
    core::Finding f = compare(0.0, {allowed("review")});  // a blind bore has its keyway up to its end
    f.what = "length behind the keyway of a blind bore into which a broach or a slotting tool can run out";
    f.suggestion = solid::set_screw_change(name(design), design.part.options.hub);
    f.suggestion.or_else(fmt::format("a groove of {:g} mm turned behind the keyway, deeper than it", f.allowed))
        .or_else("the keyway sunk by erosion");
    return {f};
}

core::Findings measure_shaft_bore_fit(const Design& design, const Allowed& allowed) {
    const solid::HubOptions& hub = design.part.options.hub;
    const core::Range fit = process_limits(design.process).fit;
    core::Finding f =
        compare(mm_from_m(hub.bore_clearance), {allowed("low_review", mm_from_m(fit.low)), allowed("high_review", mm_from_m(fit.high))});
    f.what = fmt::format("clearance of the bore on a shaft of {:g} mm", mm_from_m(hub.bore_diameter));
    f.suggestion = change(design, "hub.clearance_mm", number(f.allowed));
    return {f};
}

core::Findings measure_shaft_d_flat(const Design& design, const Allowed& allowed) {
    const solid::HubOptions& hub = design.part.options.hub;
    if (hub.lock != solid::HubLock::kDFlat) return {};
    core::Finding f = compare(hub.flat_depth / hub.bore_diameter, {allowed("low_review"), allowed("high_review")});
    f.what = fmt::format("depth of the flat over the bore of {:g} mm", mm_from_m(hub.bore_diameter));
    f.suggestion = change(design, "hub.flat_depth_mm", number(mm_from_m(f.allowed * hub.bore_diameter), 4));
    return {f};
}

core::Findings measure_shaft_hub_length(const Design& design, const Allowed& allowed) {
    const solid::HubOptions& hub = design.part.options.hub;
    const bool through = hub.kind == solid::HubKind::kThrough;
    core::Finding f = compare(bore_length(design.part) / hub.bore_diameter, {allowed(through ? "through_review" : "overhung_review")});
    f.what = fmt::format("length of the bore over its diameter of {:g} mm", mm_from_m(hub.bore_diameter));
    f.suggestion =
        change(design, "hub.boss_height_mm", up(mm_from_m(hub.boss_height) + (f.allowed - f.measured) * mm_from_m(hub.bore_diameter)));
    if (hub.boss_diameter <= 0.0)
        f.suggestion.with(key_of(design, "hub.boss_mm"),
                          up(mm_from_m(2.0 * (hub_radius(hub) + process_limits(design.process).loaded_wall))));
    return {f};
}

core::Findings measure_shaft_hub_wall(const Design& design, const Allowed& allowed) {
    const solid::HubOptions& hub = design.part.options.hub;
    if (hub.boss_diameter <= 0.0 || hub.boss_height <= 0.0) return {};
    const double radius = hub_radius(hub);
    const ProcessLimits process = process_limits(design.process);
    core::Finding f = compare(mm_from_m(0.5 * hub.boss_diameter - radius),
                              {allowed("required", mm_from_m(process.wall)), allowed("review", mm_from_m(process.loaded_wall))});
    f.what = "wall of the boss around bore and keyway";
    f.suggestion = change(design, "hub.boss_mm", up(2.0 * (mm_from_m(radius) + f.allowed)));
    return {f};
}

/// A size that should be that of the standard.
core::Finding exactly(const Design& design, const char* key, double measured, const EffectiveLimit& least, const EffectiveLimit& most,
                      const std::string& what) {
    core::Finding f = compare(mm_from_m(measured), {least, most});
    f.what = what;
    f.suggestion = change(design, key, number(f.allowed));
    return f;
}

core::Findings measure_shaft_key(const Design& design, const Allowed& allowed) {
    const solid::HubOptions& hub = design.part.options.hub;
    if (hub.lock != solid::HubLock::kKeyway) return {};

    const double bore = mm_from_m(hub.bore_diameter);
    if (const KeySize* size = key_size(hub.bore_diameter)) {
        const double b = mm_from_m(size->width), t2 = mm_from_m(size->hub_depth);
        return {exactly(design, "hub.key_width_mm", hub.key_width, allowed("least_width_review", b), allowed("width_review", b),
                        fmt::format("width b of the keyway in a {:g} mm bore", bore)),
                exactly(design, "hub.key_depth_mm", hub.key_depth, allowed("least_depth_review", t2), allowed("depth_review", t2),
                        fmt::format("depth t2 of the keyway in a {:g} mm bore", bore))};
    }
    const double least = mm_from_m(key_table().front().above), most = mm_from_m(key_table().back().up_to);
    core::Finding f = compare(bore, {allowed("least_bore_review", least), allowed("bore_review", most)});
    f.what = "bore with a keyway: the table has no key for this shaft";
    if (bore < least) f.suggestion = change(design, "hub.lock", quoted("d_flat"));
    f.suggestion.or_else(change(design, "hub.bore_mm", number(bore < least ? least : most)));
    return {f};
}

/// Half of the zone IT9 of ISO 286 that a keyway of this width has, in the standard's loose fit JS9 [m].
double half_zone(double width) { return width <= 3e-3 ? 12.5e-6 : width <= 6e-3 ? 15e-6 : 18e-6; }

bool has_key(const Design& design) { return design.part.options.hub.lock == solid::HubLock::kKeyway; }

core::Findings measure_shaft_key_fit(const Design& design, const Allowed& allowed) {
    const solid::HubOptions& hub = design.part.options.hub;
    const bool by_hand = hub.key_fit == solid::KeyFit::kByHand;
    const double tolerance = process_limits(design.process).tolerance;
    core::Finding f = compare(by_hand ? 0.0 : mm_from_m(tolerance), {allowed("review", mm_from_m(half_zone(hub.key_width)))});
    f.what = by_hand
                 ? fmt::format("tolerance of a keyway of {:g} mm that is filed or broached to its key", mm_from_m(hub.key_width))
                 : fmt::format("tolerance of a keyway of {:g} mm as made by {}: the part may turn by {:.1f} deg on its key, or not take it",
                               mm_from_m(hub.key_width), to_string(design.process.kind), deg_from_rad(4.0 * tolerance / hub.bore_diameter));
    f.suggestion = change(design, "hub.key_fit", quoted("by_hand"))
                       .noted(fmt::format(": filed{} to +-{:g} mm", hub.kind == solid::HubKind::kThrough ? " or broached" : "", f.allowed));
    return {f};
}

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

constexpr double kShare = 0.5;      // of the shaft's diameter
constexpr double kThinnest = 0.25;  // half of it: a screw that still holds a small torque (practice)

core::Findings measure_shaft_screw(const Design& design, const Allowed& allowed) {
    const solid::HubOptions& hub = design.part.options.hub;
    if (hub.lock != solid::HubLock::kSetScrew || hub.screw_diameter <= 0.0) return {};
    const double screw = mm_from_m(hub.screw_diameter), bore = mm_from_m(hub.bore_diameter);
    core::Finding size = compare(screw, {allowed("least_review", kThinnest * bore), allowed("most_review", kShare * bore)});
    size.what = fmt::format("set screw in a {:g} mm bore: about half the shaft's diameter", bore);
    size.suggestion = change(design, "hub.screw_mm", number(size.allowed));
    const double wall = process_limits(design.process).wall;
    core::Finding boss = compare(mm_from_m(hub.boss_height), {allowed("boss_required", mm_from_m(hub.screw_diameter + 2.0 * wall))});
    boss.what = "height of the boss that holds the set screw and a wall on both sides";
    boss.suggestion = change(design, "hub.boss_height_mm", up(boss.allowed));
    return {size, boss};
}

constexpr double kScrew = 4.17e-3, kTorque = 1.5;  // #8-32 [m], [Nm]

core::Findings measure_shaft_screw_torque(const Design& design, const Allowed& allowed) {
    const solid::HubOptions& hub = design.part.options.hub;
    if (hub.lock != solid::HubLock::kSetScrew || hub.screw_diameter <= 0.0 || design.part.cam.working.empty()) return {};
    const double share = hub.screw_diameter / kScrew;
    core::Finding f = compare(largest_torque(design.part.cam), {allowed("required", kTorque * share * share)});
    f.what = "largest torque that the set screw transmits to the shaft";
    f.suggestion = change(design, "hub.screw_mm", up(mm_from_m(kScrew) * std::sqrt(f.measured / kTorque)))
                       .or_else(change(design, "hub.lock", quoted("keyway")));
    return {f};
}

constexpr double kHold = 0.25;  // of the screw's force, as friction on the shaft

bool has_screw(const Design& design) {
    const solid::HubOptions& hub = design.part.options.hub;
    return works(design) && hub.lock == solid::HubLock::kSetScrew && hub.screw_diameter > 0.0 && hub.boss_diameter > hub.bore_diameter;
}

core::Findings measure_shaft_thread_strip(const Design& design, const Allowed& allowed) {
    const solid::HubOptions& hub = design.part.options.hub;
    const Material material = material_of(design.process);
    const double force = 2.0 * largest_torque(design.part.cam) / (kHold * hub.bore_diameter);
    const double length = 0.5 * (hub.boss_diameter - hub.bore_diameter);
    const double bears = thread_strength(hub.screw_diameter, length, material);
    core::Finding f = compare(bears / force, {allowed("required")});
    f.what = fmt::format("safety of the screw's thread in {:.3g} mm of {}: {:.0f} N against the {:.0f} N that hold the shaft",
                         mm_from_m(length), material.name, bears, force);
    f.suggestion = change(design, "hub.boss_mm", up(mm_from_m(hub.bore_diameter + 2.0 * length * f.allowed / f.measured)))
                       .or_else(fmt::format("a nut or insert for {:.0f} N", force));
    return {f};
}

bool is_overhung(const Design& design) {
    return works(design) && design.part.options.hub.kind == solid::HubKind::kOverhung && bore_length(design.part) > 0.0;
}

core::Findings measure_shaft_tilt(const Design& design, const Allowed& allowed) {
    const solid::HubOptions& hub = design.part.options.hub;
    const double length = bore_length(design.part);
    core::Finding f = compare(deg_from_rad(std::atan(hub.bore_clearance / length)), {allowed("review")});
    f.what = fmt::format("angle by which the cam can tilt on its shaft: {:g} mm of clearance over {:.3g} mm of bore",
                         mm_from_m(hub.bore_clearance), mm_from_m(length));
    const double longer = hub.bore_clearance / std::tan(rad_from_deg(f.allowed)) - length;
    f.suggestion = change(design, "hub.boss_height_mm", up(mm_from_m(hub.boss_height + longer)));
    return {f};
}

}  // namespace

Rules shaft_rules() {
    return {
        {"shaft.blind_keyway",
         "a keyway in a blind bore, which no tool can leave",
         "milled, overhung: space behind the keyway for the tool's run-out; fusee draws none",
         "cncbroachtools: a blind keyway ends in a groove or cross hole, 0.08 in beyond its end; a broach bar needs an open bore",
         {review(kAtLeast, "mm", 2.0)},
         measure_shaft_blind_keyway,
         has_blind_keyway},
        {"shaft.bore_fit",
         "a bore too tight or too loose on its shaft",
         "clearance of the bore on the shaft, in diameter",
         "clearances of printing: 3dservicesusa, cifproto, arti90, layerx3d; the others (practice)",
         {of_process(review(kAtLeast, "mm", "the process's least fit", "low_review")),
          of_process(review(kAtMost, "mm", "the process's largest fit", "high_review"))},
         measure_shaft_bore_fit},
        {"shaft.d_flat",
         "a flat too shallow to hold, or so deep that it weakens the shaft",
         "D-flat: its depth over the bore",
         "0.05 to 0.25 (practice)",
         {review(kAtLeast, "", 0.05, "low_review"), review(kAtMost, "", 0.25, "high_review")},
         measure_shaft_d_flat},
        {"shaft.hub_length",
         "a hub so short that the part tilts on its shaft",
         "length over which the bore holds the shaft, in bore diameters",
         "through: half a diameter, overhung: one (practice)",
         {review(kAtLeast, "diameters", 0.5, "through_review"), review(kAtLeast, "diameters", 1.0, "overhung_review")},
         measure_shaft_hub_length},
        {"shaft.hub_wall",
         "a boss that bursts around its shaft",
         "wall of the boss around bore and keyway",
         "the process's walls: thin required, loaded recommended",
         {of_process(required(kAtLeast, "mm", "the process's wall")), of_process(review(kAtLeast, "mm", "the process's loaded wall"))},
         measure_shaft_hub_wall},
        {"shaft.key",
         "a keyway that no bought key fits",
         "b and t2 of the keyway; its bore, where the table has no key",
         "DIN 6885-1",
         {review(kAtLeast, "mm", "table 4", "least_width_review"), review(kAtMost, "mm", "table 4", "width_review"),
          review(kAtLeast, "mm", "table 4", "least_depth_review"), review(kAtMost, "mm", "table 4", "depth_review"),
          review(kAtLeast, "mm", "table 4", "least_bore_review"), review(kAtMost, "mm", "table 4", "bore_review")},
         measure_shaft_key},
        {"shaft.key_fit",
         "a keyway with a fit that the process cannot hold",
         "the process's tolerance of the keyway's width; 0 if hub.key_fit says that it is fitted by hand",
         "DIN 6885-1: hub keyway P9 or JS9, half of IT9 by ISO 286",
         {review(kAtMost, "mm", "half of IT9: 0.0125 up to 3 mm of width, 0.015 up to 6, else 0.018")},
         measure_shaft_key_fit,
         has_key},
        {"shaft.key_pressure",
         "a key that crushes its keyway",
         "keyway: 2 M/(bore (h - t1) length) at the largest torque",
         "DIN 6885-1: the key stands h - t1 in the hub. In a metal it may press with 0.9 of the yield strength (DIN 6892 method C, by "
         "hanslhansl/engineering-standards-library): a reserve of 1.11. The standard is for metals: the limit of a plastic is its strength "
         "in compression, and the finding states what is left to it; pressure does not tire a hub (tribology-abc), and the springs bound "
         "the torque. Others want a third where loads are not known (Mott), 21 MPa in a laminate (Tufnol): [[limits]] states yours. The "
         "whole length bears",
         {review(kAtMost, "MPa", "cable.max_pressure_MPa, or the material's bearing strength (table 5), of metals 0.9 of it")},
         measure_shaft_key_pressure,
         is_keyed},
        {"shaft.screw",
         "a set screw that does not suit shaft and boss",
         "set screw's diameter; height of its boss",
         "machinedesign, ficientdesign: about half the shaft's diameter",
         {review(kAtLeast, "mm", "a quarter of the bore", "least_review"), review(kAtMost, "mm", "half the bore", "most_review"),
          required(kAtLeast, "mm", "screw + 2 walls of the process", "boss_required")},
         measure_shaft_screw},
        {"shaft.screw_torque",
         "a set screw that slips on its shaft",
         "set screw: largest tension times arm",
         "machinedesign, ficientdesign: #8-32 cup about 1.5 Nm; as the square of the diameter (practice)",
         {required(kAtMost, "Nm", "1.5 Nm (screw/4.17 mm)^2")},
         measure_shaft_screw_torque},
        {"shaft.thread_strip",
         "a set screw whose thread strips out of the boss",
         "set screw: shear strength of its thread in the boss's wall over the force that holds the largest torque",
         "shear area 0.875 pi d L of a 60 deg thread; ficientdesign: the shaft is held by a quarter of the screw's force; shear strength "
         "half of the tensile one (practice)",
         {required(kAtLeast, "", 1.0)},
         measure_shaft_thread_strip,
         has_screw},
        on_cable({"shaft.tilt",
                  "an overhung cam that tilts on its shaft, so that its cable leaves the groove's plane at an angle",
                  "overhung: clearance of the bore over its length",
                  "geometry; limit: that of cable.fleet, wirerope.net",
                  {review(kAtMost, "deg", 2.0)},
                  measure_shaft_tilt,
                  is_overhung}),
    };
}

}  // namespace fusee::checks
