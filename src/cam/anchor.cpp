#include "fusee/cam/contact.h"
#include "fusee/core/units.h"

namespace fusee::cam {

namespace {

constexpr double kStep_deg = 5.0, kMost_deg = 170.0;  // largest margin of a profile

}  // namespace

double anchor_direction(const Cam& cam, double margin) {
    const double wound = cam.options.torque_sign > 0 ? cam.working_psi.low : cam.working_psi.high;
    const double psi = wound - cam.options.torque_sign * margin;
    return cam.closed() && psi < cam.working_psi.low ? psi + core::kTurn : psi;
}

std::vector<double> margins_by_distance(const Cam& cam) {
    const double own = core::deg_from_rad(cam.options.path.margin);
    std::vector<double> all{cam.options.path.margin};
    for (double step = kStep_deg; step < kMost_deg; step += kStep_deg)
        for (const double margin : {own + step, own - step})
            if (margin >= kStep_deg && margin <= kMost_deg) all.push_back(core::rad_from_deg(margin));
    return all;
}

Cam with_margin(Cam cam, double margin) {
    cam.options.path.margin = margin;
    cam.anchor_psi = anchor_direction(cam, margin);
    return cam;
}

}  // namespace fusee::cam
