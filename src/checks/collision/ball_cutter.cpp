#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_collision_ball_cutter(const Design& design, const Allowed& allowed) {
    const double cutter = mm_from_m(process_limits(design.process).cutter_radius);
    if (!is_milled(design) || cutter <= 0.0) return {};
    const double ratio = design.part.options.groove.radius_ratio;
    core::Finding f = compare(mm_from_m(ratio * design.cable.diameter), {allowed("required", cutter)});
    f.what = "radius of the groove's floor, which the ball cutter must fit";
    f.suggestion = change("process.cutter_radius_mm", down(f.measured)).or_else(change("cable.diameter_mm", up(f.allowed / ratio)));
    return {f};
}

}  // namespace

Rule collision_ball_cutter() {
    return {"collision.ball_cutter",
            "a groove too narrow for the available ball cutter",
            "milled: radius of the groove's floor",
            "geometry: a cable of 0.8 mm needs a ball below 0.86 mm",
            {required(kAtLeast, "mm", "process.cutter_radius_mm, 0.25 mm by default")},
            measure_collision_ball_cutter};
}

}  // namespace fusee::checks
