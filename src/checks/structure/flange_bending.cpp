#include "means.h"

namespace fusee::checks {

namespace {

constexpr double kLeastFleet = rad_from_deg(2.0);

core::Findings measure_structure_flange_bending(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    if (cam.working.empty() || design.part.section.empty()) return {};
    const double rib = design.part.options.groove.rib, lever = 0.5 * design.cable.diameter;
    const double thickness = rib + 0.5 * groove_width(design.part) - half_width_at_cable(design.part);
    const auto stress = [&](const cam::Contact& c) {
        const double aside = c.arm.tension / c.path.rho * std::tan(std::max(std::abs(c.fleet), kLeastFleet));
        return 6.0 * aside * lever / (thickness * thickness);
    };
    const cam::Contact& worst = worst_contact(cam, stress);
    core::Finding f = compare(stress(worst) / kPaPerMPa, {allowed("review", material_of(design.process).permanent / kPaPerMPa)});
    f.what = fmt::format("bending stress of the flange beside the cable at {:.1f} N", worst.arm.tension);
    locate(f, design, worst.path);
    const double thicker = thickness * std::sqrt(f.measured / f.allowed) - thickness;
    f.suggestion = change("groove.rib_mm", up(mm_from_m(rib + thicker)));
    return {f};
}

}  // namespace

Rule structure_flange_bending() {
    return on_cable({"structure.flange_bending",
                     "a flange that the cable bends off",
                     "bending stress of the flange under the cable's side force T/rho tan(fleet, at least 2 deg) at the cable's height",
                     "cantilever of the flange's thickness there; permanent stress of the material (table 5)",
                     {review(kAtMost, "MPa", "the material's permanent stress (table 5)")},
                     measure_structure_flange_bending});
}

}  // namespace fusee::checks
