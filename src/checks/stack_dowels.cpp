#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "fusee/checks/limits.h"
#include "fusee/core/units.h"
#include "measure.h"
#include "rules.h"
#include "shape.h"
#include "spring_change.h"

namespace fusee::checks {

namespace {

constexpr double kDowel = 2e-3;             // diameter [m]
constexpr double kStep = core::kPi / 36.0;  // between directions looked at
constexpr double kGrazing = 0.1;            // tangents that a ray meets flatter than this bound it nowhere near

core::Findings run(const Design& design, const Allowed& allowed) {
    const std::vector<cam::PathPoint> path = contour(design.part.cam);
    if (!is_stacked(design) || path.empty()) return {};
    const double inner = bore_radius(design.part.options.hub), floor = -0.5 * design.cable.diameter;
    const auto room = [&](double angle) {  // along a ray from the bore's edge to the floor
        double reach = std::numeric_limits<double>::infinity();
        for (const cam::PathPoint& p : path)
            if (const double c = std::cos(p.psi - angle); c > kGrazing) reach = std::min(reach, (p.h + floor) / c);
        return reach - inner;
    };
    double best = -std::numeric_limits<double>::infinity();
    for (double angle = 0.0; angle < core::kPi; angle += kStep) best = std::max(best, std::min(room(angle), room(angle + core::kPi)));
    core::Finding f =
        judge(core::mm_from_m(best), {allowed("required", core::mm_from_m(kDowel + 2.0 * process_limits(design.process).wall))});
    f.what = "room between bore and groove floor on two opposite sides, for dowels that hold the plates in line";
    const double lacking = core::m_from_mm(f.allowed - f.measured), arm = best + inner - floor;
    const double bore = design.part.options.hub.bore_diameter - 2.0 * lacking;
    if (bore > inner) f.suggestion = fmt::format("{}.hub.bore_mm = {}, or ", name(design), down(core::mm_from_m(bore)));
    f.suggestion += scale_arms(design, (arm + lacking) / arm);
    return {f};
}

}  // namespace

Rule stack_dowels() {
    return {"stack.dowels",
            "plates that cannot be aligned",
            "plates: largest room for two opposite dowels between bore and groove floor",
            "two dowels of 2 mm, a wall on both sides (practice)",
            {required(kAtLeast, "mm", "2 mm + 2 walls of the process")},
            run};
}

}  // namespace fusee::checks
