#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "fusee/checks/limits.h"
#include "fusee/core/units.h"
#include "measure.h"
#include "rules.h"

namespace fusee::checks {

namespace {

constexpr double kDeep = 4.0, kDeepest = 10.0;  // drilled holes, in diameters

struct Hole {
    double diameter, depth;  // [m]
    const char* what;
    const char* key;
};

std::vector<Hole> holes(const solid::Part& part) {
    const solid::HubOptions& hub = part.options.hub;
    const bool through = hub.kind == solid::HubKind::kThrough;
    const double height = part.z_high - part.z_low + hub.boss_height;
    std::vector<Hole> all{{hub.bore_diameter + hub.bore_clearance,
                           through ? height : std::max(0.0, hub.boss_height + part.options.groove.rib - hub.web), "bore", "hub.bore_mm"}};
    if (part.options.features.anchor_hole_diameter > 0.0)
        all.push_back(
            {part.options.features.anchor_hole_diameter, 0.5 * (part.z_high - part.z_low), "anchor hole", "features.anchor_hole_mm"});
    if (hub.lock == solid::HubLock::kSetScrew && hub.screw_diameter > 0.0)
        all.push_back({hub.screw_diameter, 0.5 * (hub.boss_diameter - hub.bore_diameter), "set screw's hole", "hub.screw_mm"});
    return all;
}

core::Findings run(const Design& design) {
    const std::vector<Hole> all = holes(design.part);
    const Hole least = *std::min_element(all.begin(), all.end(), [](const Hole& a, const Hole& b) { return a.diameter < b.diameter; });
    core::Finding f = at_least(core::mm_from_m(least.diameter), {core::mm_from_m(process_limits(design.process).hole), {}}, "mm");
    f.what = fmt::format("diameter of the smallest hole: {}", least.what);
    f.suggestion = fmt::format("{}.{} = {}", name(design), least.key, up(f.allowed));
    core::Findings findings{f};
    if (design.process.kind != ProcessKind::kMill) return findings;
    const auto ratio = [](const Hole& hole) { return hole.depth / hole.diameter; };
    const Hole deep = *std::max_element(all.begin(), all.end(), [&](const Hole& a, const Hole& b) { return ratio(a) < ratio(b); });
    core::Finding depth = at_most(ratio(deep), {kDeepest, kDeep}, "diameters");
    depth.what = fmt::format("depth of the slenderest hole: {}", deep.what);
    depth.suggestion = fmt::format("{}.{} = {}", name(design), deep.key, up(core::mm_from_m(deep.depth) / depth.allowed));
    findings.push_back(depth);
    return findings;
}

}  // namespace

Rule process_hole() {
    return {"process.hole", "a hole too small or too deep to make", "the process's least hole; milling: 4 diameters deep, at most 10", run};
}

}  // namespace fusee::checks
