#include <fmt/format.h>

#include "fusee/checks/check.h"

namespace fusee::checks {

namespace {

/// "required change: `required_mm` at least the process's wall; review: `review_mm` at least 1.2 mm"
std::string limits_text(const Card& rule) {
    std::string text;
    for (const Limit& limit : rule.limits)
        text += fmt::format("{}{}: `{}` {}", text.empty() ? "" : "; ",
                            limit.severity == core::Severity::kRequired ? "required change" : "review", limit.key(), limit.text());
    return text;
}

}  // namespace

std::string reference(const std::vector<const Card*>& cards) {
    std::string text;
    std::string_view group;
    for (const Card* rule : cards) {
        if (rule->group() != group) {
            group = rule->group();
            text += fmt::format("{}### {}: {}\n\n| rule | guards against | measured | limits | source |\n|---|---|---|---|---|\n",
                                text.empty() ? "" : "\n", group, group_title(group));
        }
        text += fmt::format("| `{}` | {} | {} | {} | {} |\n", rule->id, rule->title, rule->measures, limits_text(*rule), rule->source);
    }
    return text;
}

std::string rules_reference() {
    std::vector<const Card*> cards;
    for (const Rule& rule : rules()) cards.push_back(&rule);
    return reference(cards);
}

}  // namespace fusee::checks
