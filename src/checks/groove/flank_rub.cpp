#include "fusee/solid/stack.h"
#include "means.h"

namespace fusee::checks {

namespace {

constexpr double kWidest = 150.0;  // [deg] throat of a groove

/// Half the groove's width between the lips for another throat (docs/theory/cams.md, eq. 11) [m].
double half_width(const Design& design, double throat) {
    const solid::GrooveOptions& groove = design.part.options.groove;
    const double radius = groove.radius_ratio * design.cable.diameter, half = 0.5 * throat;
    const double flank = groove.depth_ratio * design.cable.diameter - radius * (1.0 - std::sin(half));
    return radius * std::cos(half) + flank * std::tan(half);
}

core::Findings measure_groove_flank_rub(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    if (cam.working.size() < 2 || design.part.section.empty()) return {};
    const bool stacked = is_stacked(design) && cam.closed();  // otherwise stack.climb judges it
    const double half = 0.5 * (stacked ? solid::core_thickness(design.part) : groove_width(design.part)), lip = lip_offset(design.part),
                 radius = 0.5 * design.cable.diameter;
    // On a floor of radius rho the cable passes the lips sqrt((rho + lip)^2 - rho^2) behind its contact.
    const auto aside = [&](const cam::Contact& c) {
        const double slope = cam.closed() ? 0.0 : groove_slope(cam, c), past = std::sqrt(std::max(0.0, lip) * (2.0 * c.path.rho + lip));
        return past * std::tan(std::abs(std::atan(slope) - c.fleet));
    };
    const cam::Contact& worst = worst_contact(cam, aside);
    core::Finding f = compare(mm_from_m(half - radius - aside(worst)), {allowed("review")});
    f.what =
        fmt::format("clearance between a lip and the cable, which is {:.3f} mm off the groove's middle there", mm_from_m(aside(worst)));
    locate(f, design, worst.path, lip);
    const double needed = half + m_from_mm(f.allowed - f.measured);
    f.suggestion = change("groove.plate_mm", up(mm_from_m(2.0 * needed)));
    if (stacked) return {f};
    double throat = deg_from_rad(design.part.options.groove.throat);
    while (throat < kWidest && half_width(design, rad_from_deg(throat)) < needed) throat += 1.0;
    f.suggestion = change("groove.throat_deg", fmt::format("{:.0f}", std::min(std::ceil(throat), kWidest)));
    return {f};
}

}  // namespace

Rule groove_flank_rub() {
    return {"groove.flank_rub",
            "the free cable rubbing on a lip",
            "least clearance between the lips and the free cable, at its angle to the groove",
            "geometry: cable against the lips",
            {review(kAtLeast, "mm", 0.0)},
            measure_groove_flank_rub};
}

}  // namespace fusee::checks
