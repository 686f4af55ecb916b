#include <fmt/format.h>

#include <algorithm>

#include "gaps.h"
#include "measure.h"

namespace fusee::assembly {

namespace {

/// Pairs that keep apart at the samples, but are not proven to between them.
std::optional<core::Finding> unproven(const std::vector<Gap>& gaps, double enough_mm) {
    const auto count = std::count_if(gaps.begin(), gaps.end(), [&](const Gap& gap) { return !is_proven(gap, enough_mm); });
    if (count == 0) return std::nullopt;
    const auto worst = std::min_element(gaps.begin(), gaps.end(), [&](const Gap& a, const Gap& b) {
        return std::pair(is_proven(a, enough_mm), a.proven_mm) < std::pair(is_proven(b, enough_mm), b.proven_mm);
    });
    return core::not_judged(
        "joint.body_gap",
        fmt::format("{} pairs of bodies between the sampled poses; least proven distance {:.2f} mm, of {} and {}, sampled "
                    "{:.2f} mm",
                    count, worst->proven_mm, worst->a, worst->b, worst->mm),
        "another place of one of them, with more space");
}

core::Findings measure_joint_body_gap(const Assembly& assembly, const Allowed& allowed) {
    const double enough = allowed("review").value();
    const std::vector<Gap> gaps = body_gaps(assembly, enough);
    if (gaps.empty()) return {};
    const Gap& least = gaps.front();
    core::Finding f = checks::compare(least.mm, {allowed("required"), allowed("review")});
    f.what = fmt::format("distance of {} and {}, proven between all poses: at least {:.2f} mm", least.a, least.b, least.proven_mm);
    f.where = place_text(least.pose);
    f.suggestion = assembly.options.motor_distance > 0.0
                       ? core::change("assembly.motor_distance_mm", "0").noted(", which takes the least that the bodies need")
                       : "another assembly.k_pe_direction_deg, or a farther guide";
    core::Findings all{f};
    if (const auto open = unproven(gaps, enough); open) all.push_back(*open);
    return all;
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
