#include <fmt/format.h>

#include "fusee/core/units.h"
#include "fusee/spring/coil.h"
#include "measure.h"
#include "needs.h"
#include "spring_change.h"

namespace fusee::checks {

namespace {

core::Findings measure_spring_rod(const Design& design, const Allowed& allowed) {
    const spring::BaseSpring& s = design.spring;
    const double inside = spring::inside_diameter(s, largest_state(design));
    core::Finding f = judge(inside / s.rod_diameter, {allowed("required"), allowed("review")});
    f.what = fmt::format("inside diameter of the loaded coils, {:.2f} mm, over the rod's", core::mm_from_m(inside));
    f.suggestion = fmt::format("{}.spring.rod_mm = {}", name(design), down(core::mm_from_m(inside / f.allowed)));
    return {f};
}

}  // namespace

Rule spring_rod() {
    return {"spring.rod",
            "a coil that seizes on the rod inside it",
            "inside diameter of the coils, wound to the largest state, over that of arbor or rod",
            "arbor clearance about 10 % (Newcomb)",
            {required(kAtLeast, "", 1.0), review(kAtLeast, "", 1.1)},
            measure_spring_rod,
            false,
            {need::kWire, need::kCoil, need::kRod, need::kWoundCoils}};
}

}  // namespace fusee::checks
