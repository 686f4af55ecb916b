#include "fusee/solid/stack.h"
#include "means.h"

namespace fusee::checks {

namespace {

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

}  // namespace

Rule stack_slot_depth() {
    return on_cable({"stack.slot_depth",
                     "a slot that ends inside a plate",
                     "plates: depth of the spring leg's slot less the thickness of the upper flange, or of flange and groove's plate",
                     "geometry: a plate is cut through; 0.05 mm (practice)",
                     {required(kAtMost, "mm", 0.05)},
                     measure_stack_slot_depth,
                     has_cut_slot});
}

}  // namespace fusee::checks
