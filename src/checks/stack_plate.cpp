#include <fmt/format.h>

#include <algorithm>

#include "fusee/core/units.h"
#include "measure.h"
#include "rules.h"
#include "shape.h"

namespace fusee::checks {

namespace {

core::Findings run(const Design& design, const Allowed& allowed) {
    if (!is_stacked(design)) return {};
    const double flange = design.part.options.groove.rib, middle = groove_plate(design.part);
    core::Finding f = judge(core::mm_from_m(std::min(flange, middle)), {allowed("review")});
    f.what = fmt::format("thinnest plate: {}", flange < middle ? "flange" : "the groove's, as thick as two floor radii");
    f.suggestion = flange < middle
                       ? fmt::format("groove.rib_mm = {}", up(f.allowed))
                       : fmt::format("cable.diameter_mm = {}", up(core::mm_from_m(design.cable.diameter) * f.allowed / f.measured));
    return {f};
}

}  // namespace

Rule stack_plate() {
    return {"stack.plate",       "a plate too thin to cut and handle", "plates: thinnest of the flanges' and the groove's",
            "0.5 mm (practice)", {review(kAtLeast, "mm", 0.5)},        run};
}

}  // namespace fusee::checks
