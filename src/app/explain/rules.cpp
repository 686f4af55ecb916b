#include <fmt/ranges.h>

#include <cmath>

#include "arguments.h"
#include "explain/entry.h"
#include "fusee/assembly/rule.h"
#include "fusee/checks/check.h"
#include "fusee/core/text.h"
#include "fusee/inspect/rule.h"
#include "output.h"

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

namespace {

struct RulesArguments {
    bool markdown = false;
    std::vector<std::string> words;
};

/// A line behind a rule's id, which gets 28 letters, or on lines of its own where the terminal is narrow.
class Lines {
public:
    explicit Lines(std::size_t columns) : columns_(columns), indent_(columns < kNarrow ? 6 : 31) {}
    void rule(const checks::RuleInfo& rule) {
        if (indent_ > 6)
            text += fmt::format("  {:28} ", rule.id) + core::wrapped(rule.title, columns_, indent_).substr(indent_);
        else
            text += fmt::format("  {}\n{}", rule.id, core::wrapped(rule.title, columns_, 4));
        text += "\n";
    }
    void more(const std::string& line) { text += core::wrapped(line, columns_, indent_ + 2, 2) + "\n"; }
    std::string text;

private:
    static constexpr std::size_t kNarrow = 120;
    std::size_t columns_, indent_;
};

std::string rules_text(const std::vector<ListedRule>& rules, std::size_t columns) {
    std::string_view group;
    Lines lines(columns);
    for (const ListedRule& listed : rules) {
        const checks::RuleInfo& rule = *listed.info;
        if (rule.group() != group) {
            lines.text += fmt::format("{}{}: {}\n", group.empty() ? "" : "\n", rule.group(), checks::group_title(rule.group()));
            group = rule.group();
        }
        lines.rule(rule);
        lines.more(fmt::format("measured: {}", rule.measures));
        for (const checks::Limit& limit : rule.limits)
            lines.more(fmt::format("{}: {} {}", core::to_string(limit.severity), limit.key(), limit.text()));
        for (const std::string& need : listed.needs) lines.more("not judged without " + need);
        lines.more(fmt::format("source: {}", rule.source));
    }
    return lines.text;
}

/// The tables of all rules, for the site of the documents.
std::string rules_markdown() {
    return checks::rules_reference() + "\n" + checks::reference(checks::infos_of(assembly::rules())) + "\n" +
           checks::reference(checks::infos_of(inspect::rules()));
}

int run_rules(const RulesArguments& arguments, Reply& reply) {
    const std::vector<ListedRule> found = find_rules(arguments.words);
    reply.result = Json::array();
    if (reply.json())
        for (const ListedRule& rule : found) reply.result.push_back(rule_json(rule));
    reply.print(arguments.markdown ? rules_markdown() : rules_text(found, columns_out()));
    return 0;
}

}  // namespace

void add_rules(CLI::App& app, Action& action) {
    const auto [command, arguments] = add_command(app, action, "rules", run_rules);
    CLI::Option* words = command->add_option("words", arguments->words, "Beginning of ids, or a word in them, such as cable; default: all");
    words->type_name("WORD");
    command->add_flag("--markdown", arguments->markdown, "Print all rules as Markdown tables")->excludes(words);
    command->footer(
        "Example:\n  fusee rules cable\n  fusee rules | less\n  fusee rules --json > rules.json\n\n"
        "A profile replaces a limit in [[limits]]: rule, the name of the limit = a number, and reason.");
}

}  // namespace fusee::app
