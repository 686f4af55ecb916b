#include "fusee/solid/stack.h"

#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_stack_boss(const Design& design, const Allowed& allowed) {
    const solid::HubOptions& hub = design.part.options.hub;
    core::Finding f = compare(mm_from_m(hub.boss_height), {allowed("required")});
    f.what = "height of the boss below the plates";
    f.suggestion = change(design, "hub.boss_height_mm", number(f.allowed)).with(key_of(design, "hub.kind"), quoted("through"));
    return {f};
}

core::Findings measure_stack_climb(const Design& design, const Allowed& allowed) {
    const std::vector<cam::PathPoint> path = contour(design.part.cam);
    if (!is_stacked(design) || path.empty()) return {};
    const auto [low, high] = std::minmax_element(path.begin(), path.end(), [](const auto& a, const auto& b) { return a.z < b.z; });
    core::Finding f = compare(mm_from_m(high->z - low->z), {allowed("required")});
    f.what = "rise of the groove from end to end";
    f.suggestion = change(design, "path.kind", quoted("planar")).noted(fmt::format(" without lead, pitch_mm and hand: {:g} mm", f.allowed));
    return {f};
}

constexpr double kMore = 1.02;  // times the lacking width: the space grows a little more slowly than the bore shrinks

core::Findings measure_stack_dowels(const Design& design, const Allowed& allowed) {
    if (!is_stacked(design) || !design.part.cam.closed() || design.part.section.empty()) return {};
    const double space = solid::place_dowels(design.part).space_mm, wall = mm_from_m(process_limits(design.process).wall);
    core::Finding f = compare(space, {allowed("required", solid::kDowel_mm + 2.0 * wall)});
    f.what = "diameter of the free circles around two opposite dowels, clear of bore, holes and groove floor";
    const double lacking = m_from_mm(kMore * (f.allowed - f.measured)), bore = design.part.options.hub.bore_diameter;
    if (bore > 2.0 * lacking) f.suggestion = change(design, "hub.bore_mm", down(mm_from_m(bore - 2.0 * lacking)));
    const double arm = design.part.cam.working.empty() ? bore : design.part.cam.working.front().path.h;
    f.suggestion.or_else(scale_arms(design, (arm + lacking) / arm));
    return {f};
}

core::Findings measure_stack_groove_width(const Design& design, const Allowed& allowed) {
    const double d = design.cable.diameter;
    core::Finding f = compare(solid::core_thickness(design.part) / d, {allowed("required"), allowed("low_review"), allowed("high_review")});
    f.what =
        fmt::format("thickness of the groove's plate, {:.3f} mm, over the cable's diameter", mm_from_m(solid::core_thickness(design.part)));
    const double plate = mm_from_m(f.allowed * d);
    f.suggestion = change("groove.plate_mm", f.bound == kAtLeast ? up(plate) : down(plate));
    return {f};
}

core::Findings measure_stack_hole(const Design& design, const Allowed& allowed) {
    const Hole least = smallest_hole(design.part);
    const double thickest = std::max(design.part.options.groove.rib, solid::core_thickness(design.part));
    core::Finding f = compare(least.diameter / thickest, {allowed("review")});
    f.what = fmt::format("diameter of the smallest hole over the thickest plate, {:.2f} mm: {}", mm_from_m(thickest), least.what);
    f.suggestion = change(design, least.key, up(mm_from_m(f.allowed * thickest)));
    if (thickest > solid::core_thickness(design.part))
        f.suggestion.or_else(change("groove.rib_mm", down(mm_from_m(least.diameter / f.allowed))));
    return {f};
}

core::Findings measure_stack_kerf(const Design& design, const Allowed& allowed) {
    const solid::PartOptions& options = design.part.options;
    const bool key = options.hub.lock == solid::HubLock::kKeyway, slot = has_slot(options.features);
    if (!is_stacked(design) || (!key && !slot)) return {};
    const bool at_slot = slot && (!key || options.features.leg_slot_width < options.hub.key_width);
    const double narrowest = at_slot ? options.features.leg_slot_width : options.hub.key_width;
    const double kerf = 2.0 * process_limits(design.process).cutter_radius;
    core::Finding f = compare(mm_from_m(narrowest), {allowed("review", mm_from_m(1.5 * kerf))});
    f.what = fmt::format("narrowest opening of the plates: {}", at_slot ? "spring leg's slot" : "keyway");
    f.suggestion = change(design, at_slot ? "features.leg_slot_width_mm" : "hub.key_width_mm", up(f.allowed));
    return {f};
}

core::Findings measure_stack_plate(const Design& design, const Allowed& allowed) {
    const double flange = design.part.options.groove.rib, middle = solid::core_thickness(design.part);
    core::Finding f = compare(mm_from_m(std::min(flange, middle)), {allowed("review")});
    f.what = fmt::format("thinnest plate: {}", flange < middle ? "flange" : "the groove's");
    f.suggestion = change(flange < middle ? "groove.rib_mm" : "groove.plate_mm", up(f.allowed));
    if (flange >= middle) f.suggestion.or_else(change("cable.diameter_mm", up(mm_from_m(design.cable.diameter) * f.allowed / f.measured)));
    return {f};
}

bool has_cut_slot(const Design& design) { return is_stacked(design) && has_leg_slot(design); }

core::Findings measure_stack_slot_depth(const Design& design, const Allowed& allowed) {
    const double depth = design.part.options.features.leg_slot_depth, upper = design.part.options.groove.rib;
    const double both = upper + solid::core_thickness(design.part);
    const double sheets = std::abs(depth - upper) <= std::abs(depth - both) ? upper : both;
    core::Finding f = compare(mm_from_m(std::abs(depth - sheets)), {allowed("required")});
    f.what = fmt::format("difference between the depth of the spring leg's slot, {:g} mm, and the plates that it is cut through, {:g} mm",
                         mm_from_m(depth), mm_from_m(sheets));
    f.where = at_leg_slot(design);
    f.suggestion = change(design, "features.leg_slot_depth_mm", number(mm_from_m(sheets)));
    return {f};
}

core::Findings measure_stack_wire(const Design& design, const Allowed& allowed) {
    const solid::FeatureOptions& features = design.part.options.features;
    const double hole = features.anchor_hole_diameter, slot = has_slot(features) ? features.leg_slot_width : 0.0;
    if (!is_stacked(design) || (hole <= 0.0 && slot <= 0.0)) return {};
    const bool at_slot = slot > 0.0 && (hole <= 0.0 || slot < hole);
    core::Finding f =
        compare(mm_from_m(0.5 * (at_slot ? slot : hole)), {allowed("required", mm_from_m(process_limits(design.process).cutter_radius))});
    f.what = fmt::format("least inner radius of the plates: {}", at_slot ? "ends of the spring leg's slot" : "anchor hole");
    f.suggestion = change(design, at_slot ? "features.leg_slot_width_mm" : "features.anchor_hole_mm", up(2.0 * f.allowed));
    return {f};
}

}  // namespace

Rules stack_rules() {
    return {
        {"stack.boss",
         "a boss, which a stack of plates cannot have",
         "plates: height of the boss",
         "geometry: plates are cut through",
         {required(kAtMost, "mm", 0.0)},
         measure_stack_boss,
         is_stacked},
        on_cable({"stack.climb",
                  "a helical groove, which flat plates cannot hold",
                  "plates: rise of the groove",
                  "geometry: plates are flat",
                  {required(kAtMost, "mm", 0.0)},
                  measure_stack_climb}),
        on_cable({"stack.dowels",
                  "plates that cannot be aligned",
                  "plates: diameter of the largest free circles around two opposite dowels",
                  "two dowels of 2 mm, a wall on both sides (practice)",
                  {required(kAtLeast, "mm", "2 mm + 2 walls of the process")},
                  measure_stack_dowels}),
        on_cable({"stack.groove_width",
                  "flanges that pinch the cable, or a groove so wide that turns of the cable slip beside each other",
                  "plates: thickness of the groove's plate over the cable's diameter",
                  "geometry: the cable lies between the flanges; 5 % of clearance, half a cable at most (practice)",
                  {required(kAtLeast, "d", 1.0), review(kAtLeast, "d", 1.05, "low_review"), review(kAtMost, "d", 1.5, "high_review")},
                  measure_stack_groove_width,
                  is_stacked}),
        on_cable({"stack.hole",
                  "a hole smaller than its plate is thick",
                  "plates: smallest hole over the thickest plate",
                  "one thickness (practice)",
                  {review(kAtLeast, "thicknesses", 1.0)},
                  measure_stack_hole,
                  is_stacked}),
        {"stack.kerf",
         "an opening hardly wider than the cut",
         "plates: narrowest of keyway and slot",
         "1.5 kerfs (practice)",
         {review(kAtLeast, "mm", "1.5 kerfs, 3 process.cutter_radius_mm")},
         measure_stack_kerf},
        on_cable({"stack.plate",
                  "a plate too thin to cut and handle",
                  "plates: thinnest of the flanges' and the groove's",
                  "0.5 mm (practice)",
                  {review(kAtLeast, "mm", 0.5)},
                  measure_stack_plate,
                  is_stacked}),
        on_cable({"stack.slot_depth",
                  "a slot that ends inside a plate",
                  "plates: depth of the spring leg's slot less the thickness of the upper flange, or of flange and groove's plate",
                  "geometry: a plate is cut through; 0.05 mm (practice)",
                  {required(kAtMost, "mm", 0.05)},
                  measure_stack_slot_depth,
                  has_cut_slot}),
        {"stack.wire",
         "an inner radius that the wire or beam cannot cut",
         "plates: least radius of anchor hole and slot's ends",
         "wire radius + gap 0.145 mm, half a laser's kerf 0.1 mm (practice)",
         {required(kAtLeast, "mm", "process.cutter_radius_mm: wire radius + gap, half the kerf")},
         measure_stack_wire},
    };
}

}  // namespace fusee::checks
