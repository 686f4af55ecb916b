#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_spring_index(const Design& design, const Allowed& allowed) {
    const spring::BaseSpring& s = design.spring;
    core::Finding f = compare(spring::spring_index(s), {allowed("low_required"), allowed("high_required"), allowed("review")});
    f.what = "index of the base spring: mean coil diameter over wire";
    f.suggestion = change(design, "spring.coil_mm", number(mm_from_m(f.allowed * s.wire_diameter), 4));
    return {f};
}

}  // namespace

Rule spring_index() {
    return {"spring.index",
            "a coil too tight or too loose to wind",
            "spring index D/w",
            "EN 15800, EN 13906-3: 4 to 20; 16 (practice)",
            {required(kAtLeast, "", 4.0, "low_required"), required(kAtMost, "", 20.0, "high_required"), review(kAtMost, "", 16.0)},
            measure_spring_index,
            nullptr,
            {need::kWire, need::kCoil}};
}

}  // namespace fusee::checks
