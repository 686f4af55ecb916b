#include "fusee/core/units.h"
#include "means.h"

namespace fusee::checks {

namespace {

constexpr double kSampled = 1e-6;  // the closing arc reaches its least radius between samples

/// The ends of the working arc belong to it in any turn; otherwise a part and its mirror image would differ.
bool is_idle(const cam::Cam& cam, double psi) {
    constexpr double kRounding = 1e-9;  // [rad]
    const core::Range working = cam.working_psi;
    if (cam.closed() && psi > working.low + core::kTurn - kRounding) return false;
    return psi < working.low - kRounding || psi > working.high + kRounding;
}

core::Findings measure_structure_idle_curvature(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    const cam::PathPoint* sharpest = nullptr;
    const std::vector<cam::PathPoint> path = contour(cam);
    for (const cam::PathPoint& p : path)
        if (is_idle(cam, p.psi) && (!sharpest || !(p.rho >= sharpest->rho))) sharpest = &p;
    if (!sharpest) return {};
    const double cusp = mm_from_m(0.5 * design.cable.diameter), wanted = mm_from_m(cam.options.path.min_idle_curvature_radius);
    core::Finding f = compare(mm_from_m(sharpest->rho) * (1.0 + kSampled), {allowed("required", cusp), allowed("review", wanted)});
    f.what = "least radius of curvature outside the working arc; the groove's floor has a cusp below half a cable";
    locate(f, design, *sharpest, -0.5 * design.cable.diameter);
    const double margin = deg_from_rad(cam.options.path.margin);
    // An arc that already keeps its least radius elsewhere is as sharp as the ends of the working arc. Then min_idle_radius_mm must be
    // smaller.
    const std::string radius = f.severity == core::Severity::kWarning ? down(f.measured) : up(f.allowed);
    f.suggestion = cam.closed() ? change(design, "path.min_idle_radius_mm", radius)
                                : change(design, "path.margin_deg", up(1.5 * margin)).noted(": a longer run-out has a larger radius");
    return {f};
}

}  // namespace

Rule structure_idle_curvature() {
    return {"structure.idle_curvature",
            "a contour too sharp to cut outside its working arc",
            "least rho outside the working arc",
            "geometry: rho > d/2; path.min_idle_radius_mm",
            {required(kAtLeast, "mm", "d/2"), review(kAtLeast, "mm", "path.min_idle_radius_mm")},
            measure_structure_idle_curvature};
}

}  // namespace fusee::checks
