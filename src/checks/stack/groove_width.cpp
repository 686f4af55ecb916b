#include "fusee/solid/stack.h"
#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_stack_groove_width(const Design& design, const Allowed& allowed) {
    const double d = design.cable.diameter;
    core::Finding f = compare(solid::core_thickness(design.part) / d, {allowed("required"), allowed("low_review"), allowed("high_review")});
    f.what =
        fmt::format("thickness of the groove's plate, {:.3f} mm, over the cable's diameter", mm_from_m(solid::core_thickness(design.part)));
    const double plate = mm_from_m(f.allowed * d);
    f.suggestion = change("groove.plate_mm", f.bound == kAtLeast ? up(plate) : down(plate));
    return {f};
}

}  // namespace

Rule stack_groove_width() {
    return on_cable({"stack.groove_width",
                     "flanges that pinch the cable, or a groove so wide that turns of the cable slip beside each other",
                     "plates: thickness of the groove's plate over the cable's diameter",
                     "geometry: the cable lies between the flanges; 5 % of clearance, half a cable at most (practice)",
                     {required(kAtLeast, "d", 1.0), review(kAtLeast, "d", 1.05, "low_review"), review(kAtMost, "d", 1.5, "high_review")},
                     measure_stack_groove_width,
                     is_stacked});
}

}  // namespace fusee::checks
