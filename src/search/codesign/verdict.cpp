#include "verdict.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace fusee::search::codesign {

namespace {

constexpr double kNear = 0.01;
/// Rules that depend on groove, hub and process only, or on a radius that the closing arc always exhausts.
constexpr std::array<std::string_view, 14> kUnmoved{"groove.",
                                                    "shaft.",
                                                    "process.hole",
                                                    "process.wall",
                                                    "process.detail",
                                                    "structure.idle_curvature",
                                                    "structure.hole_edge",
                                                    "collision.",
                                                    "fdm.",
                                                    "sla.",
                                                    "sls.",
                                                    "mill.",
                                                    "stack.",
                                                    "assembly."};

bool moved(const Limit& limit) {
    return std::none_of(kUnmoved.begin(), kUnmoved.end(), [&](std::string_view rule) { return limit.name.starts_with(rule); });
}

}  // namespace

std::vector<Limit> binding(const Trial& trial) {
    std::vector<Limit> all;
    for (const Limit& limit : trial.limits)
        if (std::abs(limit.excess()) < kNear && moved(limit)) all.push_back(limit);
    return all;
}

core::Findings broken(const Trial& trial) {
    std::vector<Limit> worst;
    for (const Limit& limit : trial.limits)
        if (limit.excess() > 0.0) worst.push_back(limit);
    std::stable_sort(worst.begin(), worst.end(), [](const Limit& a, const Limit& b) { return a.excess() > b.excess(); });
    core::Findings findings;
    for (const Limit& limit : worst) {
        const auto space = limit.name.find(' ');
        core::Finding f = core::error_finding(limit.name.substr(0, space), "the nearest design found breaks this limit", limit.measured,
                                              limit.bound, limit.allowed, limit.unit);
        if (space != std::string::npos) f.where = limit.name.substr(space + 1);
        f.suggestion = "wider bounds, weaker demands or more generations in [co_design] and [design]";
        f.source = "docs/theory/co_design.md";
        findings.push_back(std::move(f));
    }
    return findings;
}

}  // namespace fusee::search::codesign
