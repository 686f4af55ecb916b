#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_roller_undercut(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    const cam::Roller& roller = cam.options.roller;
    const cam::Contact& sharpest = worst_contact(cam, [](const cam::Contact& c) { return -c.path.rho; });
    const double pitch = sharpest.path.rho + roller.radius;
    core::Finding f = compare(pitch / roller.radius, {allowed("required"), allowed("review")});
    f.what = fmt::format("least radius of curvature of the roller centre's curve, {:.2f} mm, over the roller's", mm_from_m(pitch));
    locate(f, design, sharpest.path);
    f.suggestion = change(design, "roller.radius_mm", down(mm_from_m(pitch) / f.allowed))
                       .or_else(cam::base_change(roller, up(mm_from_m(roller.base_radius + f.allowed * roller.radius - pitch))));
    return {f};
}

}  // namespace

Rule roller_undercut() {
    return {"roller.undercut",
            "a rim with a cusp under its roller",
            "least radius of curvature of the roller centre's curve on the working arc, in roller radii",
            "R. L. Norton, Cam Design and Manufacturing Handbook: at least 2 to 3; at 1 the rim is a cusp; 1.1 (practice)",
            {required(kAtLeast, "roller radii", 1.1), review(kAtLeast, "roller radii", 2.0)},
            measure_roller_undercut,
            works};
}

}  // namespace fusee::checks
