#include <vector>

#include "means.h"

namespace fusee::checks {

namespace {

/// h between two samples: the cubic with their values and slopes. @pre psi within the path
double arm_at(const std::vector<cam::PathPoint>& path, double psi) {
    const auto after = std::upper_bound(path.begin() + 1, path.end() - 1, psi, [](double v, const cam::PathPoint& p) { return v < p.psi; });
    const cam::PathPoint &a = *(after - 1), &b = *after;
    const double step = b.psi - a.psi, s = step > 0.0 ? (psi - a.psi) / step : 0.0, t = 1.0 - s;
    return t * t * (1.0 + 2.0 * s) * a.h + s * s * (1.0 + 2.0 * t) * b.h + s * t * step * (t * a.slope - s * b.slope);
}

core::Findings measure_structure_neck(const Design& design, const Allowed& allowed) {
    const std::vector<cam::PathPoint> path = contour(design.part.cam);
    const cam::PathPoint* narrowest = nullptr;
    double least = 0.0;
    for (const cam::PathPoint& p : path)
        for (const double opposite :
             {p.psi - core::kPi, p.psi + core::kPi}) {  // both: the low end of the mirror image is the high end here
            if (opposite < path.front().psi || opposite > path.back().psi) continue;
            const double width = p.h + arm_at(path, opposite) - design.cable.diameter;
            if (!narrowest || width < least) narrowest = &p, least = width;
        }
    if (!narrowest) return {};
    core::Finding f = compare(mm_from_m(least), {allowed("review", mm_from_m(process_limits(design.process).feature))});
    f.what = "least width of the core between the groove's floors on both sides";
    locate(f, design, *narrowest, -0.5 * design.cable.diameter);
    f.suggestion = scale_arms(design, (f.allowed + mm_from_m(design.cable.diameter)) / (f.measured + mm_from_m(design.cable.diameter)));
    return {f};
}

}  // namespace

Rule structure_neck() {
    return {"structure.neck",
            "a core so thin that the part breaks in two",
            "least width of the core between two opposite places of the floor",
            "the process's least feature",
            {of_process(review(kAtLeast, "mm", "the process's feature"))},
            measure_structure_neck};
}

}  // namespace fusee::checks
