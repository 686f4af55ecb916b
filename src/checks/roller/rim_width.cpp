#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_roller_rim_width(const Design& design, const Allowed& allowed) {
    const solid::PartOptions& options = design.part.options;
    const double width = design.part.cam.options.roller.width, beside = 2.0 * options.groove.rib;
    core::Finding f = compare(mm_from_m(options.rim_width - beside), {allowed("required", mm_from_m(width))});
    f.what = "width of the rim between its two ribs, on which the roller runs";
    f.suggestion = change(design, "roller.rim_width_mm", up(f.allowed + mm_from_m(beside)));
    return {f};
}

}  // namespace

Rule roller_rim_width() {
    return {"roller.rim_width",
            "a roller that hangs over its rim or strikes the flange of a boss",
            "width of the rim less a rib on both sides",
            "geometry: the roller's own width",
            {required(kAtLeast, "mm", "k_pe.roller.width_mm")},
            measure_roller_rim_width};
}

}  // namespace fusee::checks
