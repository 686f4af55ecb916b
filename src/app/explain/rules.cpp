#include "rules.h"

#include <algorithm>
#include <cmath>

#include "fusee/assembly/rule.h"
#include "fusee/checks/check.h"
#include "fusee/core/text.h"
#include "fusee/inspect/rule.h"
#include "fusee/profile/keys.h"

namespace fusee::app {

namespace {

bool id_begins(const ListedRule& rule, const std::string& word) { return core::lower(rule.info->id).starts_with(word); }
bool rule_has(const ListedRule& rule, const std::string& word) {
    return core::lower(std::string(rule.info->id) + " " + rule.info->title + " " + rule.info->measures).find(word) != std::string::npos;
}

[[noreturn]] void refuse_rule_word(const std::string& word) {
    std::vector<std::string> names;
    for (const ListedRule& rule : all_rules()) {
        names.emplace_back(rule.info->group());
        names.emplace_back(rule.info->id);
    }
    throw core::InvalidInput("rules", word, "the beginning of a rule's id, or a word in its title" + core::did_you_mean(word, names));
}

Json limit_json(const checks::Limit& limit) {
    Json j{{"limit", limit.key()},
           {"severity", core::to_string(limit.severity)},
           {"bound", limit.bound == core::Bound::kAtMost ? "at most" : "at least"},
           {"unit", limit.unit}};
    if (std::isnan(limit.value))
        j["default_by"] = limit.by;
    else
        j["default"] = limit.value;
    return j;
}

}  // namespace

std::vector<ListedRule> all_rules() {
    std::vector<ListedRule> all;
    for (const checks::Rule& rule : checks::rules()) {
        ListedRule& listed = all.emplace_back(ListedRule{&rule, rule.needs_mesh, {}});
        for (const checks::Need& need : rule.needs) listed.needs.emplace_back(need.key);
    }
    for (const assembly::Rule& rule : assembly::rules()) all.push_back({&rule, true, {}});
    for (const inspect::Rule& rule : inspect::rules()) all.push_back({&rule, true, {}});
    return all;
}

std::vector<ListedRule> find_rules(const std::vector<std::string>& words) {
    return profile::asked_for(all_rules(), words, id_begins, rule_has, refuse_rule_word);
}

Json rule_json(const ListedRule& rule) {
    Json limits = Json::array();
    for (const checks::Limit& limit : rule.info->limits) limits.push_back(limit_json(limit));
    return {{"rule", rule.info->id},
            {"group", rule.info->group()},
            {"severity", core::to_string(rule.info->severity())},
            {"guards_against", rule.info->title},
            {"measured", rule.info->measures},
            {"limits", limits},
            {"source", rule.info->source},
            {"needs_mesh", rule.needs_mesh},
            {"needs_keys", rule.needs}};
}

}  // namespace fusee::app
