#include "means.h"

namespace fusee::checks {

namespace {

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

}  // namespace

Rule stack_kerf() {
    return {"stack.kerf",
            "an opening hardly wider than the cut",
            "plates: narrowest of keyway and slot",
            "1.5 kerfs (practice)",
            {review(kAtLeast, "mm", "1.5 kerfs, 3 process.cutter_radius_mm")},
            measure_stack_kerf};
}

}  // namespace fusee::checks
