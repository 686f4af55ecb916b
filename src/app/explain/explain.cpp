#include <fmt/ranges.h>

#include <algorithm>

#include "arguments.h"
#include "explain/entry.h"
#include "fusee/checks/check.h"
#include "fusee/core/lists.h"
#include "fusee/core/text.h"

namespace fusee::app {

namespace {

std::string plain(std::string text) {
    std::replace(text.begin(), text.end(), '_', ' ');
    return core::lower(text);
}
bool same(const std::string& a, const std::string& b) { return plain(a) == plain(b); }

/// The name behind its table or group.
std::string leaf_of(const std::string& path) { return path.substr(path.rfind('.') + 1); }

/// Cuts the name before the next dot off a path.
std::string_view next_name(std::string_view& path) {
    const std::string_view name = path.substr(0, path.find('.'));
    path.remove_prefix(std::min(name.size() + 1, path.size()));
    return name;
}

/// "parameters.mass" and "parameters.mass.tolerance" are of "parameters.NAME".
bool names_key(const FileKey& key, const std::string& asked) {
    if (key.path.find("NAME") == std::string::npos) return same(key.path, asked);
    std::string_view pattern = key.path, path = asked;
    bool any = false;
    while (!pattern.empty()) {
        const std::string_view wanted = next_name(pattern), name = next_name(path);
        any = wanted == "NAME" || wanted == "COLUMN";
        if (any ? name.empty() : wanted != name) return false;
    }
    return path.empty() || (any && path.find('.') == std::string_view::npos);
}

/// "agonist, antagonist" is both; "dead-band, exact" is also found as "dead-band".
bool names_term(const Term& term, const std::string& asked) {
    const std::vector<std::string> names = core::pieces_of<std::string>(term.name, ", ");
    return same(term.name, asked) || std::any_of(names.begin(), names.end(), [&](const std::string& name) { return same(name, asked); });
}

/// "U_4, P = U_4'', F_PE" has the symbols U_4, P and F_PE; "(k, u, C)" those in it.
bool has_symbol(const Term& term, const std::string& asked) {
    std::string text = term.symbol;
    std::erase_if(text, [](char c) { return c == '(' || c == ')'; });
    const std::vector<std::string> symbols = core::pieces_of<std::string>(text, ", ");
    return std::any_of(symbols.begin(), symbols.end(), [&](const std::string& one) { return one.substr(0, one.find(" = ")) == asked; });
}

/// A table of keys or a group of rules, as the list of what it holds.
void add_list(std::vector<Entry>& found, const char* kind, const std::string& name, const std::string& title,
              const std::vector<std::string>& members, const char* command) {
    if (members.empty()) return;
    Entry entry{kind, name, {}, {{"kind", kind}, {"name", name}, {"title", title}, {"members", members}}};
    if (!title.empty()) entry.lines.emplace_back("about", title);
    entry.lines.emplace_back("holds", fmt::format("{}", fmt::join(members, ", ")));
    entry.lines.emplace_back("more", fmt::format("fusee {} {}", command, name));
    found.push_back(std::move(entry));
}

std::vector<std::string> all_names() {
    std::vector<std::string> names;
    for (const ListedRule& rule : all_rules())
        names.insert(names.end(), {rule.info->id, std::string(rule.info->group()), leaf_of(rule.info->id)});
    for (const profile::KeyInfo& key : profile::key_infos()) names.insert(names.end(), {key.path, key.table, leaf_of(key.path)});
    for (const effects::Effect& effect : effects::effect_library()) names.push_back(effect.id);
    for (const effects::Term& term : effects::term_library()) names.push_back(term.effect.id);
    for (const NamedFinding& finding : named_findings()) names.emplace_back(finding.id);
    for (const Term& term : glossary_terms()) names.push_back(term.name);
    for (const FileKey& key : file_keys()) names.insert(names.end(), {key.path, leaf_of(key.path)});
    return names;
}

/// Rules, effects and keys whose last part is the name: "bore_mm" is one of two parts.
void add_by_leaf(std::vector<Entry>& found, const std::string& name) {
    for (const ListedRule& rule : all_rules())
        if (same(leaf_of(rule.info->id), name)) found.push_back(rule_entry(rule));
    for (const effects::Effect& effect : effects::effect_library())
        if (same(leaf_of(effect.id), name)) found.push_back(effect_entry(effect));
    for (const profile::KeyInfo& key : profile::key_infos())
        if (same(leaf_of(key.path), name) || plain(key.path).ends_with(plain("." + name))) found.push_back(key_entry(key));
    for (const FileKey& key : file_keys())
        if (same(leaf_of(key.path), name)) found.push_back(file_key_entry(key));
}

}  // namespace

std::vector<Term> glossary_terms() {
    std::vector<Term> terms;
    for (const TableRow& row : table_rows(kGlossary))
        terms.push_back({row.section, row.cell("term"), row.cell("symbol"), row.cell("meaning")});
    return terms;
}

Entry term_entry(const Term& term) {
    Entry entry{"term",
                term.name,
                {},
                {{"kind", "term"}, {"name", term.name}, {"section", term.section}, {"symbol", term.symbol}, {"meaning", term.meaning}}};
    entry.lines.emplace_back("means", term.meaning.empty() ? "see docs/glossary.md" : term.meaning);
    if (!term.symbol.empty()) entry.lines.emplace_back("symbol", term.symbol);
    entry.lines.emplace_back("about", term.section);
    return entry;
}

std::vector<Entry> explain(const std::string& name) {
    std::vector<Entry> found;
    std::vector<std::string> group, table;
    for (const ListedRule& rule : all_rules()) {
        if (same(rule.info->id, name)) found.push_back(rule_entry(rule));
        if (same(std::string(rule.info->group()), name)) group.emplace_back(rule.info->id);
    }
    for (const effects::Effect& effect : effects::effect_library())
        if (same(effect.id, name)) found.push_back(effect_entry(effect));
    for (const NamedFinding& finding : named_findings())
        if (same(std::string(finding.id), name)) found.push_back(finding_entry(finding));
    if (const effects::Term* term = effects::term_or_none(name)) found.push_back(generic_entry(*term));
    for (const profile::KeyInfo& key : profile::key_infos()) {
        if (same(key.path, name)) found.push_back(key_entry(key));
        if (same(key.table, name)) table.push_back(key.path);
    }
    for (const FileKey& key : file_keys())
        if (names_key(key, name)) found.push_back(file_key_entry(key));
    for (const Term& term : glossary_terms())
        if (names_term(term, name) || has_symbol(term, name)) found.push_back(term_entry(term));
    add_list(found, "group", name, group.empty() ? "" : checks::group_title(group.front().substr(0, group.front().find('.'))), group,
             "rules");
    add_list(found, "table", name, "", table, "keys");
    if (found.empty()) add_by_leaf(found, name);
    if (found.empty())
        throw core::InvalidInput(
            "explain", name,
            "a rule, a key or table of a profile, a key of case.toml or of a study, an effect, a term or symbol of the glossary" +
                core::did_you_mean(name, all_names()));
    return found;
}

std::string entry_text(const Entry& entry, std::size_t columns) {
    constexpr std::size_t kIndent = 2;
    std::string text = fmt::format("{}: {}\n", entry.name, entry.kind);
    for (const auto& [label, line] : entry.lines) text += core::wrapped(label + ": " + line, columns, kIndent, kIndent) + "\n";
    return text;
}

namespace {

int run_explain(const std::vector<std::string>& names, Reply& reply) {
    Json all = Json::array();
    bool first = true;
    for (const std::string& name : names)
        for (const Entry& entry : explain(name)) {
            all.push_back(entry.json);
            reply.print((first ? "" : "\n") + entry_text(entry, core::terminal_columns()));
            first = false;
        }
    reply.result = {{"entries", all}};
    return 0;
}

}  // namespace

void add_explain(CLI::App& app, Action& action) {
    const auto [command, names] = add_command(app, action, "explain", run_explain);
    command->add_option("name", *names, "Id of a rule, finding or effect, key or table of a profile, term or symbol of the glossary")
        ->required()
        ->type_name("NAME");
    command->footer(
        "Example:\n  fusee explain cable.bend_ratio\n  fusee explain law.start_torque_Nm\n  fusee explain gear.coulomb\n"
        "  fusee explain dead-band\n\n"
        "Exit code: 0, or 2 for a name that nothing has (near ones are named).");
}

}  // namespace fusee::app
