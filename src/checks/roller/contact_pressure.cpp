#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_roller_contact_pressure(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    const cam::Roller& roller = cam.options.roller;
    const auto most = allowed.stated("required", roller.max_pressure / kPaPerMPa);
    const auto pressure = [&](const cam::Contact& c) { return cam::contact_pressure(c.arm, cam.options); };
    const cam::Contact& worst = worst_contact(cam, pressure);
    core::Finding f = compare(pressure(worst) / kPaPerMPa, {*most});
    f.what = fmt::format("largest pressure between rim and roller, at a spring force of {:.1f} N", worst.arm.tension);
    locate(f, design, worst.path);
    const double ratio = f.measured / f.allowed;
    f.suggestion = change(design, "roller.width_mm", up(mm_from_m(roller.width * ratio * ratio)));
    return {f};
}

}  // namespace

Rule roller_contact_pressure() {
    return {"roller.contact_pressure",
            "a rim that its roller wears or dents",
            "largest pressure of two cylinders along one line, over the working arc",
            "Hertz: sqrt(N E*/(pi width) (1/R_r + 1/rho)), K. L. Johnson, Contact Mechanics, 1985",
            {required(kAtMost, "MPa", "k_pe.roller.max_pressure_MPa; not judged without it and contact_modulus_MPa")},
            measure_roller_contact_pressure,
            works,
            {need::kRollerPressure, need::kContactModulus}};
}

}  // namespace fusee::checks
