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

}  // namespace

Rule stack_boss() {
    return {"stack.boss",
            "a boss, which a stack of plates cannot have",
            "plates: height of the boss",
            "geometry: plates are cut through",
            {required(kAtMost, "mm", 0.0)},
            measure_stack_boss,
            is_stacked};
}

}  // namespace fusee::checks
