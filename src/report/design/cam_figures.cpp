#include "design/cam_figures.h"

#include <algorithm>
#include <cassert>

namespace fusee::report {

namespace {
void widen(core::Range& range, double value) {
    range.low = std::min(range.low, value);
    range.high = std::max(range.high, value);
}
}  // namespace

CamFigures measure(const cam::Cam& cam) {
    assert(!cam.working.empty());
    const cam::Contact& first = cam.working.front();
    const double arm_mm = core::mm_from_m(first.arm.arm);
    CamFigures f{cam.working.back().arm.angle - first.arm.angle,
                 {arm_mm, arm_mm},
                 {first.arm.tension, first.arm.tension},
                 {first.arm.state, first.arm.state},
                 core::mm_from_m(first.path.rho)};
    for (const cam::Contact& contact : cam.working) {
        widen(f.arms_mm, core::mm_from_m(contact.arm.arm));
        widen(f.tensions, contact.arm.tension);
        widen(f.states, contact.arm.state);
        f.least_rho_mm = std::min(f.least_rho_mm, core::mm_from_m(contact.path.rho));
    }
    return f;
}

}  // namespace fusee::report
