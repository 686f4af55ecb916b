#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_spring_active_coils(const Design& design, const Allowed& allowed) {
    core::Finding f = compare(design.spring.active_coils, {allowed("required"), allowed("review")});
    f.what = "active coils of the base spring";
    f.suggestion = change(design, "spring.active_coils", up(f.allowed));
    return {f};
}

}  // namespace

Rule spring_active_coils() {
    return {"spring.active_coils",
            "a spring whose end coils dominate its rate",
            "active coils",
            "EN 15800, EN 13906-3: at least 2; 3 (practice)",
            {required(kAtLeast, "", 2.0), review(kAtLeast, "", 3.0)},
            measure_spring_active_coils,
            nullptr,
            {need::kActiveCoils}};
}

}  // namespace fusee::checks
