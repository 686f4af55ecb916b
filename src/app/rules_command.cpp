#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "arguments.h"
#include "commands.h"
#include "explain/entry.h"
#include "fusee/assembly/rule.h"
#include "fusee/checks/check.h"
#include "fusee/inspect/rule.h"
#include "output.h"
#include "reply.h"

namespace fusee::app {

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
std::string rules_markdown() { return checks::rules_reference() + "\n" + assembly::rules_reference() + "\n" + inspect::rules_reference(); }

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
