#include <fmt/format.h>

#include <cmath>

#include "fusee/core/units.h"
#include "measure.h"
#include "rules.h"
#include "shape.h"

namespace fusee::checks {

namespace {

/// Slope of the groove, dz/ds, in the direction in which the cable leaves (with the tension's torque, along torque_sign t).
double groove_slope(const cam::Cam& cam, const cam::Contact& c) {
    const cam::Contact &first = cam.working.front(), &last = cam.working.back();
    const cam::PathPoint &before = (&c == &first ? &c : &c - 1)->path, &after = (&c == &last ? &c : &c + 1)->path;
    return cam.options.torque_sign * (after.z - before.z) / ((after.psi - before.psi) * c.path.rho);
}

core::Findings run(const Design& design) {
    const cam::Cam& cam = design.part.cam;
    if (cam.closed() || cam.working.size() < 2) return {};
    const auto angle = [&cam](const cam::Contact& c) { return std::abs(std::atan(groove_slope(cam, c)) - c.fleet); };
    const cam::Contact& worst = worst_contact(cam, angle);
    core::Finding f = at_most(core::deg_from_rad(angle(worst)), {{}, 4.0}, "deg");
    f.what = "angle between the free cable and the groove that it leaves: it rubs on a flank";
    f.where = where(design, worst.path.psi);
    f.place = place(worst.path, 0.0);
    if (cam.options.path.lead == cam::Lead::kConstantPitch)
        f.suggestion = fmt::format(
            "{}.path.pitch_mm = {}, or {}.path.lead = \"aimed\"", name(design),
            down(core::mm_from_m(cam.options.path.pitch) * std::tan(core::rad_from_deg(f.allowed)) / std::tan(angle(worst))), name(design));
    else
        f.suggestion = fmt::format("{}.guide.z_mm = {:.3g}: half height", name(design),
                                   core::mm_from_m(0.5 * (cam.working.front().path.z + cam.working.back().path.z)));
    return {f};
}

}  // namespace

Rule cable_groove_angle() {
    return {"cable.groove_angle", "the cable leaving a climbing groove across its flank",
            "US7677540B1: a focused groove points at the guide; 4 deg (practice)", run};
}

}  // namespace fusee::checks
