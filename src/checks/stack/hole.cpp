#include "fusee/solid/stack.h"
#include "means.h"

namespace fusee::checks {

namespace {

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

}  // namespace

Rule stack_hole() {
    return on_cable({"stack.hole",
                     "a hole smaller than its plate is thick",
                     "plates: smallest hole over the thickest plate",
                     "one thickness (practice)",
                     {review(kAtLeast, "thicknesses", 1.0)},
                     measure_stack_hole,
                     is_stacked});
}

}  // namespace fusee::checks
