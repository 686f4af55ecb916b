#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fusee/checks/rule.h"
#include "fusee/effects/term.h"
#include "fusee/profile/keys.h"
#include "reply.h"

/// What `fusee explain` says about one name. The texts are those of the rules, the schema of keys, the fault library, the glossary and the
/// pages of cases and studies.
namespace fusee::app {

/// A rule of parts, of the joint or of meshes.
struct ListedRule {
    const checks::RuleInfo* info = nullptr;
    bool needs_mesh = false;
    std::vector<std::string> needs;  ///< keys without which it is not judged
};
[[nodiscard]] std::vector<ListedRule> all_rules();

/// The rules that `words` ask for: each asks for the groups and ids that begin with it; if there is none, for rules with the word in id,
/// title or measured quantity. No words: all. @throws core::InvalidInput naming a word that no rule has, and near ones
[[nodiscard]] std::vector<ListedRule> find_rules(const std::vector<std::string>& words);

[[nodiscard]] Json rule_json(const ListedRule& rule);

struct Entry {
    std::string kind;  ///< "rule", "key", "effect", "generic term", "term", "table", "group", "key of case.toml", "key of a study", or that
                       ///< of a NamedFinding
    std::string name;
    std::vector<std::pair<std::string, std::string>> lines;  ///< label, text
    Json json;                                               ///< kind, name, and the same as `lines`
};

[[nodiscard]] Entry rule_entry(const ListedRule& rule);
[[nodiscard]] Entry key_entry(const profile::KeyInfo& key);
[[nodiscard]] Entry effect_entry(const effects::Effect& effect);
[[nodiscard]] Entry generic_entry(const effects::Term& term);

/// A row of a table of a page of docs.
struct TableRow {
    std::string section;             ///< the heading above it
    std::vector<std::string> head;   ///< the table's first row
    std::vector<std::string> cells;  ///< of this row
    /// The cell below this head; "" if the table has none.
    [[nodiscard]] std::string cell(std::string_view column) const;
};
/// The rows of all tables of a page, without their heads.
[[nodiscard]] std::vector<TableRow> table_rows(std::string_view page);

/// A key of case.toml or of a study, as docs/gap.md, docs/guides/batch.md and docs/guides/my-simulator-does-not-match.md explain it.
struct FileKey {
    const char* file;                                        ///< "case.toml", "a study"
    std::string path;                                        ///< "rig.capstan_radius_m"; NAME stands for any name: "parameters.NAME"
    std::vector<std::pair<std::string, std::string>> lines;  ///< head of a column, cell
};
[[nodiscard]] const std::vector<FileKey>& file_keys();
[[nodiscard]] Entry file_key_entry(const FileKey& key);

/// A row of a table of docs/glossary.md.
struct Term {
    std::string section, name, symbol, meaning;
};
[[nodiscard]] std::vector<Term> glossary_terms();
[[nodiscard]] Entry term_entry(const Term& term);

/// An id that stands in messages and in no registry of rules, keys or effects.
struct NamedFinding {
    const char* kind;  ///< "finding of a step", "limit of a search", "effect of a subsystem case", "fault of the benchmark"
    std::string_view id, meaning;
    std::string_view remedy;  ///< what to change; "": nothing
};
[[nodiscard]] std::vector<NamedFinding> named_findings();
[[nodiscard]] Entry finding_entry(const NamedFinding& finding);

/// Everything that has this name; capitals do not count, "_" and " " are the same. A name without its table is found too: "bore_mm",
/// "hub.bore_mm". Of a symbol capitals count: "C".
/// @throws core::InvalidInput if nothing has, with near names
[[nodiscard]] std::vector<Entry> explain(const std::string& name);

/// The entry for a person, in lines of so many letters.
[[nodiscard]] std::string entry_text(const Entry& entry, std::size_t columns);

extern const std::string_view kGlossary;        ///< docs/glossary.md
extern const std::string_view kGapCases;        ///< docs/gap.md
extern const std::string_view kBatch;           ///< docs/guides/batch.md
extern const std::string_view kOwnModel;        ///< docs/guides/my-simulator-does-not-match.md
extern const std::string_view kShippedProfile;  ///< profiles/pnrvsa.toml

}  // namespace fusee::app
