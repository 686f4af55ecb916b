#include "fusee/solid/stack.h"
#include "means.h"

namespace fusee::checks {

namespace {

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

}  // namespace

Rule stack_dowels() {
    return on_cable({"stack.dowels",
                     "plates that cannot be aligned",
                     "plates: diameter of the largest free circles around two opposite dowels",
                     "two dowels of 2 mm, a wall on both sides (practice)",
                     {required(kAtLeast, "mm", "2 mm + 2 walls of the process")},
                     measure_stack_dowels});
}

}  // namespace fusee::checks
