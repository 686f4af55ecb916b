#include <fmt/format.h>

#include "gaps.h"
#include "measure.h"

namespace fusee::assembly {

namespace {

core::Findings measure_joint_cable_gap(const Assembly& assembly, const Allowed& allowed) {
    const std::vector<Gap> gaps = cable_gaps(assembly);
    if (gaps.empty()) return {};
    const Gap& least = gaps.front();
    core::Finding f = checks::compare(least.mm, {allowed("required"), allowed("review")});
    f.what = fmt::format("the {} passes {}, at sampled poses", least.a, least.b);
    f.where = place_text(least.pose);
    f.suggestion =
        least.a.starts_with(to_string(CableKind::kParallel))
            ? "another assembly.k_pe_direction_deg, or a farther guide of k_pe"
            : fmt::format("a larger assembly.motor_distance_mm than {:.0f}, or another k_se.guide", std::ceil(assembly.motor_distance_mm));
    return {f};
}

}  // namespace

Rule joint_cable_gap() {
    return {{"joint.cable_gap",
             "a cable that rubs on a body",
             "least distance of a free cable's surface from the bodies that it does not touch, over the working range",
             "no contact; a slack cable sags by about its diameter (practice)",
             {required(kAtLeast, "mm", 0.1), review(kAtLeast, "mm", 0.8)}},
            measure_joint_cable_gap};
}

}  // namespace fusee::assembly
