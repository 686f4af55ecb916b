#include "means.h"

namespace fusee::checks {

namespace {

constexpr double kStrengthStep = 0.99, kThinnest = 0.01;  // step and end of the search for a thinner cable, of d

core::Findings measure_cable_bend_strength(const Design& design, const Allowed& allowed) {
    const double d = design.cable.diameter;
    const cam::PathPoint& sharpest = worst_contact(design.part.cam, [](const cam::Contact& c) { return -c.path.rho; }).path;
    core::Finding f = compare(100.0 * strength_left(design.cable.construction, (2.0 * sharpest.rho - d) / d), {allowed("review")});
    f.what = fmt::format("strength left in the cable at its sharpest bend, rho {:.3f} mm", mm_from_m(sharpest.rho));
    locate(f, design, sharpest);
    double thinner = d;
    while (100.0 * strength_left(design.cable.construction, (2.0 * sharpest.rho - thinner) / thinner) < f.allowed &&
           thinner > kThinnest * d)
        thinner *= kStrengthStep;
    f.suggestion = change("cable.diameter_mm", down(mm_from_m(thinner)));
    return {f};
}

}  // namespace

Rule cable_bend_strength() {
    return {"cable.bend_strength",
            "a cable that loses too much strength where it bends",
            "strength left at the sharpest working bend (table 2)",
            "Sava; fibre and 70 % (practice)",
            {review(kAtLeast, "%", 70.0)},
            measure_cable_bend_strength,
            works};
}

}  // namespace fusee::checks
