#include <vector>

#include "fusee/checks/limits.h"
#include "fusee/core/units.h"
#include "measure.h"
#include "rules.h"
#include "shape.h"
#include "spring_change.h"

namespace fusee::checks {

namespace {

core::Findings run(const Design& design, const Allowed& allowed) {
    const std::vector<cam::PathPoint> path = contour(design.part.cam);
    const cam::PathPoint* narrowest = nullptr;
    double least = 0.0;
    auto opposite = path.begin();
    for (const cam::PathPoint& p : path) {
        while (opposite != path.end() && opposite->psi < p.psi + core::kPi) ++opposite;
        if (opposite == path.end()) break;
        const double width = p.h + opposite->h - design.cable.diameter;
        if (!narrowest || width < least) narrowest = &p, least = width;
    }
    if (!narrowest) return {};
    core::Finding f = judge(core::mm_from_m(least), {allowed("review", core::mm_from_m(process_limits(design.process).feature))});
    f.what = "least width of the core between the groove's floors on both sides";
    f.where = where(design, narrowest->psi);
    f.place = place(*narrowest, -0.5 * design.cable.diameter);
    f.suggestion =
        scale_arms(design, (f.allowed + core::mm_from_m(design.cable.diameter)) / (f.measured + core::mm_from_m(design.cable.diameter)));
    return {f};
}

}  // namespace

Rule structure_neck() {
    return {"structure.neck",
            "a core so thin that the part breaks in two",
            "least width of the core between two opposite places of the floor",
            "the process's least feature",
            {review(kAtLeast, "mm", "the process's feature")},
            run};
}

}  // namespace fusee::checks
