#include <vector>

#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_stack_climb(const Design& design, const Allowed& allowed) {
    const std::vector<cam::PathPoint> path = contour(design.part.cam);
    if (!is_stacked(design) || path.empty()) return {};
    const auto [low, high] = std::minmax_element(path.begin(), path.end(), [](const auto& a, const auto& b) { return a.z < b.z; });
    core::Finding f = compare(mm_from_m(high->z - low->z), {allowed("required")});
    f.what = "rise of the groove from end to end";
    f.suggestion = change(design, "path.kind", quoted("planar")).noted(fmt::format(" without lead, pitch_mm and hand: {:g} mm", f.allowed));
    return {f};
}

}  // namespace

Rule stack_climb() {
    return on_cable({"stack.climb",
                     "a helical groove, which flat plates cannot hold",
                     "plates: rise of the groove",
                     "geometry: plates are flat",
                     {required(kAtMost, "mm", 0.0)},
                     measure_stack_climb});
}

}  // namespace fusee::checks
