#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "explain/entry.h"
#include "fusee/checks/check.h"

namespace fusee::app {

namespace {

/// A value on the good side of the limit and one beyond it.
struct Pair {
    double good, bad;
};
Pair values_around(const checks::Limit& limit) {
    const double step = limit.value == 0.0 ? 0.1 : 0.1 * std::abs(limit.value);
    const double inwards = limit.bound == core::Bound::kAtLeast ? step : -step;
    return {limit.value == 0.0 ? 0.0 : limit.value + inwards, limit.value - inwards};
}

std::string limit_line(const checks::Limit& limit) {
    return fmt::format("{} {}; beyond it: {}", limit.key(), limit.text(), core::to_string(limit.severity));
}

std::string example_line(const checks::Limit& limit) {
    const Pair values = values_around(limit);
    const std::string unit = limit.unit.empty() ? "" : " " + limit.unit;
    return fmt::format("{:.4g}{} passes, {:.4g}{}: {}", values.good, unit, values.bad, unit, core::to_string(limit.severity));
}

}  // namespace

Entry rule_entry(const ListedRule& rule) {
    const checks::RuleInfo& info = *rule.info;
    Entry entry{"rule", info.id, {}, {{"kind", "rule"}, {"name", info.id}}};
    entry.json.update(rule_json(rule));
    entry.json["examples"] = Json::array();
    entry.lines = {{"guards against", info.title}, {"measured", info.measures}};
    for (const checks::Limit& limit : info.limits) {
        entry.lines.emplace_back("limit", limit_line(limit));
        if (std::isnan(limit.value)) continue;
        entry.lines.emplace_back("example", example_line(limit));
        const Pair values = values_around(limit);
        entry.json["examples"].push_back({{"limit", limit.key()}, {"good", values.good}, {"bad", values.bad}});
    }
    if (!rule.needs.empty()) entry.lines.emplace_back("not judged without", fmt::format("{}", fmt::join(rule.needs, ", ")));
    entry.lines.emplace_back("judged on", rule.needs_mesh ? "the solid of the part or the joint" : "cam, profile and springs; no solid");
    entry.lines.emplace_back("source", info.source);
    if (!info.limits.empty())
        entry.lines.emplace_back("another limit", fmt::format("[[limits]] with rule = \"{}\", {} = a number, reason = a text", info.id,
                                                              info.limits.front().key()));
    return entry;
}

}  // namespace fusee::app
