#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_structure_flange_slenderness(const Design& design, const Allowed& allowed) {
    const solid::PartOptions& options = design.part.options;
    const double height = options.groove.depth_ratio * design.cable.diameter + options.flange_height;
    core::Finding f = compare(height / options.groove.rib, {allowed("review")});
    f.what = fmt::format("height of the flange over the groove's floor, {:.2f} mm, over its thickness", mm_from_m(height));
    f.suggestion = change("groove.rib_mm", up(mm_from_m(height / f.allowed)));
    const double lower = options.flange_height - height + f.allowed * options.groove.rib;
    if (options.flange_height > 0.0 && lower >= 0.0) f.suggestion.or_else(change(design, "flange_height_mm", down(mm_from_m(lower))));
    return {f};
}

}  // namespace

Rule structure_flange_slenderness() {
    return on_cable({"structure.flange_slenderness",
                     "a flange that warps or bends when handled",
                     "height of the flange over the groove's floor, over its thickness",
                     "5 (practice)",
                     {review(kAtMost, "", 5.0)},
                     measure_structure_flange_slenderness});
}

}  // namespace fusee::checks
