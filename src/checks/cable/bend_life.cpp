#include "means.h"

namespace fusee::checks {

namespace {

constexpr double kSafety = 5.0;    // of running cable
constexpr double kExponent = 3.7;  // lg 13/lg 2

core::Findings measure_cable_bend_life(const Design& design, const Allowed& allowed) {
    const Cable& cable = design.cable;
    const CableLimits& table = cable_limits(cable.construction);
    const double d = cable.diameter;
    const BreakingLoad load = breaking_load(cable);
    // Breaking load over tension, times D/d: the reciprocal of the pressure by which tests on different sheaves agree.
    const auto factor = [&](const cam::Contact& c) {
        return load.newton / c.arm.tension * (2.0 * c.path.rho - d) / d / (kSafety * table.recommended);
    };
    const cam::Contact& worst = worst_contact(design.part.cam, [&](const cam::Contact& c) { return -factor(c); });
    if (worst.arm.tension <= 0.0) return {};
    core::Finding f = compare(factor(worst), {allowed("review")});
    f.what = fmt::format("safety x D/d at {:.1f} N, over {:g} x {:g}", worst.arm.tension, kSafety, table.recommended);
    if (!table.is_fibre() && factor(worst) > 0.0)
        f.what += fmt::format(": {:.2g} of the bending life there", std::pow(factor(worst), kExponent));
    f.what += load.remark(cable);
    locate(f, design, worst.path);
    if (factor(worst) > 0.0)
        f.suggestion = change("cable.breaking_load_N", up(load.newton * f.allowed / f.measured));
    else
        f.suggestion = fmt::format("a contour with rho above {} mm", up(mm_from_m(0.5 * d)));
    return {f};
}

}  // namespace

Rule cable_bend_life() {
    return {
        "cable.bend_life",
        "a cable that wears out by bending under its tension",
        "least of breaking load/tension x D/d, over 5 x recommended D/d (table 1)",
        "OIPEEC, F. Sloan: load share over D/d unites bending tests; wire: Sava, up to 13 times the life for twice the pulley; safety 5 "
        "(practice)",
        {review(kAtLeast, "", 1.0)},
        measure_cable_bend_life,
        works};
}

}  // namespace fusee::checks
