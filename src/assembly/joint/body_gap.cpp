#include <fmt/format.h>

#include "fusee/assembly/gaps.h"
#include "measure.h"

namespace fusee::assembly {

namespace {

core::Findings measure_joint_body_gap(const Assembly& assembly, const Allowed& allowed) {
    const std::vector<Gap> gaps = body_gaps(assembly);
    if (gaps.empty()) return {};
    const Gap& least = gaps.front();
    core::Finding f = checks::judge(least.mm, {allowed("required"), allowed("review")});
    f.what = fmt::format("distance of {} and {}", least.a, least.b);
    f.where = place_text(least.pose);
    f.suggestion = assembly.options.motor_distance > 0.0 ? "assembly.motor_distance_mm = 0, which takes the least that the bodies need"
                                                         : "another assembly.k_pe_direction_deg, or a farther guide";
    return {f};
}

}  // namespace

Rule joint_body_gap() {
    return {{"joint.body_gap",
             "two bodies of the joint that meet",
             "least distance of two bodies that do not touch by design, over the working range of both sides",
             "no contact; 0.3 mm for printed parts that move (3dservicesusa, +-0.3 mm)",
             {required(kAtLeast, "mm", 0.3), review(kAtLeast, "mm", 0.9)}},
            measure_joint_body_gap};
}

}  // namespace fusee::assembly
