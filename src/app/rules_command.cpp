#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "fusee/assembly/rule.h"
#include "fusee/checks/check.h"
#include "fusee/inspect/rule.h"

namespace fusee::app {

namespace {

using Json = nlohmann::ordered_json;

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

Json rule_json(const checks::RuleInfo& rule, bool needs_mesh, const std::vector<checks::Need>& needs) {
    Json limits = Json::array();
    for (const checks::Limit& limit : rule.limits) limits.push_back(limit_json(limit));
    Json keys = Json::array();
    for (const checks::Need& need : needs) keys.push_back(need.key);
    return {{"rule", rule.id},
            {"group", rule.group()},
            {"severity", core::to_string(rule.severity())},
            {"guards_against", rule.title},
            {"measured", rule.measures},
            {"limits", limits},
            {"source", rule.source},
            {"needs_mesh", needs_mesh},
            {"needs_keys", keys}};
}

void print_json() {
    Json all = Json::array();
    for (const checks::Rule& rule : checks::rules()) all.push_back(rule_json(rule, rule.needs_mesh, rule.needs));
    for (const assembly::Rule& rule : assembly::rules()) all.push_back(rule_json(rule, true, {}));
    for (const inspect::Rule& rule : inspect::rules()) all.push_back(rule_json(rule, true, {}));
    fmt::print("{}\n", all.dump(2));
}

/// The rules of parts, of the joint, of meshes.
std::vector<const checks::RuleInfo*> all_rules() {
    std::vector<const checks::RuleInfo*> infos;
    for (const checks::Rule& rule : checks::rules()) infos.push_back(&rule);
    for (const assembly::Rule& rule : assembly::rules()) infos.push_back(&rule);
    for (const inspect::Rule& rule : inspect::rules()) infos.push_back(&rule);
    return infos;
}

void print_text() {
    std::string_view group;
    for (const checks::RuleInfo* info : all_rules()) {
        const checks::RuleInfo& rule = *info;
        if (rule.group() != group) {
            fmt::print("{}{}: {}\n", group.empty() ? "" : "\n", rule.group(), checks::group_title(rule.group()));
            group = rule.group();
        }
        fmt::print("  {:28} {}\n", rule.id, rule.title);
        fmt::print("  {:28}   measured: {}\n", "", rule.measures);
        for (const checks::Limit& limit : rule.limits)
            fmt::print("  {:28}   {}: {} {}\n", "", core::to_string(limit.severity), limit.key(), limit.text());
        if (const checks::Rule* of_design = checks::find_rule(rule.id))
            for (const checks::Need& need : of_design->needs) fmt::print("  {:28}   not judged without {}\n", "", need.key);
        fmt::print("  {:28}   source: {}\n", "", rule.source);
    }
}

}  // namespace

void add_rules(CLI::App& app, Action& action) {
    const auto json = std::make_shared<bool>(false);
    CLI::App* command = app.add_subcommand("rules", "List every rule with its limits and sources");
    command->add_flag("--json", *json, "Print JSON");
    command->footer(
        "Example:\n  fusee rules | less\n  fusee rules --json > rules.json\n\n"
        "A profile replaces a limit in [[limits]]: rule, the name of the limit = a number, and reason.");
    command->callback([json, &action] { action = [json] { return *json ? print_json() : print_text(), 0; }; });
}

}  // namespace fusee::app
