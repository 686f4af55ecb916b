#include <fmt/format.h>

#include "fusee/checks/check.h"
#include "fusee/checks/judge.h"

namespace fusee::checks {

namespace {

/// "`required_mm` >= the process's wall; `review_mm` >= 1.2 mm": the name tells the severity.
std::string limits_text(const RuleInfo& rule) {
    std::string text;
    for (const Limit& limit : rule.limits) {
        const bool least = limit.bound == kAtLeast;
        const std::size_t words = std::string_view(least ? "at least" : "at most").size();
        text += fmt::format("{}`{}` {}{}", text.empty() ? "" : "; ", limit.key(), least ? ">=" : "<=", limit.text().substr(words));
    }
    return text;
}

/// "`spring.wire_mm`, `spring.max_travel_mm` (or `spring.free_length_mm`, `spring.wire_mm`)"
std::string needs_text(const Rule& rule) {
    std::string text;
    for (const Need& need : rule.needs) {
        std::string others;
        for (const char* other : need.or_else)
            if (other != nullptr) others += fmt::format("{}`{}`", others.empty() ? "" : ", ", other);
        text += fmt::format("{}`{}`{}", text.empty() ? "" : ", ", need.key, others.empty() ? "" : " (or " + others + ")");
    }
    return text;
}

}  // namespace

std::string reference(const std::vector<const RuleInfo*>& infos, const std::vector<std::string>& needs) {
    std::string text;
    std::string_view group;
    for (std::size_t i = 0; i < infos.size(); ++i) {
        const RuleInfo* rule = infos[i];
        const std::string needed = needs.empty() || needs[i].empty() ? "" : "; needs " + needs[i];
        if (rule->group() != group) {
            group = rule->group();
            text += fmt::format("{}### {}: {}\n\n| rule | guards against | measured | limits | source |\n|---|---|---|---|---|\n",
                                text.empty() ? "" : "\n", group, group_title(group));
        }
        text += fmt::format("| `{}` | {} | {}{} | {} | {} |\n", rule->id, rule->title, rule->measures, needed, limits_text(*rule),
                            rule->source);
    }
    return text;
}

std::string rules_reference() {
    std::vector<const RuleInfo*> infos;
    std::vector<std::string> needs;
    for (const Rule& rule : rules()) {
        infos.push_back(&rule);
        needs.push_back(needs_text(rule));
    }
    return reference(infos, needs);
}

}  // namespace fusee::checks
