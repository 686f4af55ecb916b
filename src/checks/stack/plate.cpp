#include "fusee/solid/stack.h"
#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_stack_plate(const Design& design, const Allowed& allowed) {
    const double flange = design.part.options.groove.rib, middle = solid::core_thickness(design.part);
    core::Finding f = compare(mm_from_m(std::min(flange, middle)), {allowed("review")});
    f.what = fmt::format("thinnest plate: {}", flange < middle ? "flange" : "the groove's");
    f.suggestion = change(flange < middle ? "groove.rib_mm" : "groove.plate_mm", up(f.allowed));
    if (flange >= middle) f.suggestion.or_else(change("cable.diameter_mm", up(mm_from_m(design.cable.diameter) * f.allowed / f.measured)));
    return {f};
}

}  // namespace

Rule stack_plate() {
    return on_cable({"stack.plate",
                     "a plate too thin to cut and handle",
                     "plates: thinnest of the flanges' and the groove's",
                     "0.5 mm (practice)",
                     {review(kAtLeast, "mm", 0.5)},
                     measure_stack_plate,
                     is_stacked});
}

}  // namespace fusee::checks
