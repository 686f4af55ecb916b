#include <fmt/format.h>

#include "fusee/checks/limits.h"
#include "fusee/core/units.h"
#include "measure.h"
#include "rules.h"
#include "shape.h"

namespace fusee::checks {

namespace {

constexpr double kScatter = 10.0;  // [%]: of the rates of bought springs; a contour need not be better than they are

core::Findings run(const Design& design) {
    const cam::Cam& cam = design.part.cam;
    const double tolerance = process_limits(design.process).tolerance;
    if (cam.working.empty() || tolerance <= 0.0) return {};
    const cam::Contact& least = worst_contact(cam, [](const cam::Contact& c) { return -c.arm.arm; });
    core::Finding f = at_most(100.0 * tolerance / least.arm.arm, {{}, kScatter}, "%");
    f.what = fmt::format("torque error at the least arm, {:.2f} mm, from a contour that is {:g} mm off", core::mm_from_m(least.arm.arm),
                         core::mm_from_m(tolerance));
    f.where = where(design, least.path.psi);
    f.place = place(least.path, -0.5 * design.cable.diameter);
    f.suggestion = fmt::format("process.tolerance_mm = {}: a groove coupon measured and compensated",
                               down(core::mm_from_m(least.arm.arm) * f.allowed / 100.0));
    return {f};
}

}  // namespace

Rule process_contour_error() {
    return {"process.contour_error", "a process too coarse for the arms", "EN 15800: spring rates scatter by 10 %; the process's tolerance",
            run};
}

}  // namespace fusee::checks
