#include "fusee/report/rule_counts.h"

#include <fmt/format.h>

#include <algorithm>

#include "data/figures.h"

namespace fusee::report {

namespace {

std::size_t& field_of(RuleCounts& counts, core::Severity severity) {
    switch (severity) {
        case core::Severity::kPass:
            return counts.passed;
        case core::Severity::kNotJudged:
            return counts.not_judged;
        case core::Severity::kWarning:
            return counts.review;
        case core::Severity::kError:
            break;
    }
    return counts.required;
}

}  // namespace

std::vector<RuleCounts> count_rules(const core::Findings& findings) {
    std::vector<RuleCounts> all;
    for (const core::Finding& f : findings) {
        const std::string group = f.rule.substr(0, f.rule.find('.'));
        auto row = std::find_if(all.begin(), all.end(), [&](const RuleCounts& counts) { return counts.group == group; });
        if (row == all.end()) row = all.insert(all.end(), RuleCounts{group});
        ++field_of(*row, f.severity);
    }
    return all;
}

std::string not_judged_text(const core::Findings& findings) {
    const std::size_t number = core::count(findings, core::Severity::kNotJudged);
    if (number == 0) return "";
    std::vector<RuleCounts> groups = count_rules(findings);
    std::erase_if(groups, [](const RuleCounts& counts) { return counts.not_judged == 0; });
    std::stable_sort(groups.begin(), groups.end(), [](const auto& a, const auto& b) { return a.not_judged > b.not_judged; });
    std::string text = counted(number, "rule") + " not judged:";
    for (const RuleCounts& counts : groups)
        text += fmt::format("{} {} {}", &counts == &groups.front() ? "" : ",", counts.group, counts.not_judged);
    return text;
}

}  // namespace fusee::report
