#include "means.h"

namespace fusee::checks {

namespace {

constexpr double kGuide_mm = 200.0;  // distance of a guide that had no place

/// A parallel guide has no point to aim at.
core::Suggestion aimed_change(const Design& design) {
    core::Suggestion aimed = change(design, "path.lead", quoted("aimed"));
    if (design.part.cam.options.guide.kind != cam::GuideKind::kParallel) return aimed;
    return aimed.with(key_of(design, "guide.kind"), quoted("point")).with(key_of(design, "guide.distance_mm"), number(kGuide_mm));
}

/// Cable that is taken in beyond the integral of the arm, since it crosses the groove (docs/theory/cams.md, fleet angle) [m].
template <class Angle>
double excess_intake(const cam::Cam& cam, const Angle& angle) {
    double excess = 0.0;
    for (std::size_t i = 1; i < cam.working.size(); ++i) {
        const cam::Contact &a = cam.working[i - 1], &b = cam.working[i];
        const double rho = 0.5 * (a.path.rho + b.path.rho), rise = b.path.z - a.path.z;
        excess += std::hypot(rho * (b.path.psi - a.path.psi), rise) * (1.0 - std::cos(0.5 * (angle(a) + angle(b))));
    }
    return excess;
}

core::Findings measure_cable_groove_angle(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    if (cam.closed() || cam.working.size() < 2) return {};
    const auto angle = [&cam](const cam::Contact& c) { return std::abs(std::atan(groove_slope(cam, c)) - c.fleet); };
    const cam::Contact& worst = worst_contact(cam, angle);
    core::Finding f = compare(deg_from_rad(angle(worst)), {allowed("review")});
    f.what = fmt::format(
        "angle between the free cable and its groove: it rubs on a flank, where {:.2g} % of the torque may be lost or gained; over the "
        "range the cable moves by {:.2g} mm more than the arms state",
        100.0 * (1.0 - std::cos(angle(worst))) * worst.path.rho / worst.path.h, mm_from_m(excess_intake(cam, angle)));
    locate(f, design, worst.path);
    if (cam.options.path.lead == cam::Lead::kConstantPitch)
        f.suggestion = change(design, "path.pitch_mm",
                              down(mm_from_m(cam.options.path.pitch) * std::tan(rad_from_deg(f.allowed)) / std::tan(angle(worst))))
                           .or_else(aimed_change(design));
    else
        f.suggestion = change(design, "guide.z_mm", number(mm_from_m(0.5 * (cam.working.front().path.z + cam.working.back().path.z)), 3))
                           .noted(": half height");
    return {f};
}

}  // namespace

Rule cable_groove_angle() {
    return {"cable.groove_angle",
            "the cable leaving a helical groove across its flank",
            "helix: largest angle between free cable and groove",
            "US7677540B1: a focused groove points at the guide; 4 deg (practice)",
            {review(kAtMost, "deg", 4.0)},
            measure_cable_groove_angle};
}

}  // namespace fusee::checks
