#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>

#include "explain/entry.h"
#include "fusee/core/lists.h"
#include "fusee/core/toml.h"

namespace fusee::app {

namespace {

/// The key's value as the shipped profile writes it; "" if it states none, or one of several lines.
std::string shipped_value(const std::string& path) {
    static const toml::table kProfile = core::parse_toml(kShippedProfile, "pnrvsa.toml");
    const toml::node* node = kProfile.at_path(path).node();
    if (node == nullptr || node->source().begin.line != node->source().end.line) return "";
    std::string_view text = kShippedProfile;
    for (toml::source_index line = 1; line < node->source().begin.line; ++line) text.remove_prefix(text.find('\n') + 1);
    const std::size_t begin = node->source().begin.column - 1;
    return std::string(text.substr(begin, node->source().end.column - 1 - begin));
}

/// The rules that are not judged without the key, or whose text names it.
std::vector<std::string> rules_of(const profile::KeyInfo& key) {
    std::vector<std::string> ids;
    for (const ListedRule& rule : all_rules())
        for (const std::string& need : rule.needs)
            if (need == key.path || ("k_se." + need) == key.path || ("k_pe." + need) == key.path) ids.emplace_back(rule.info->id);
    return ids;
}

std::vector<std::string> cells_of(std::string_view line) {
    std::vector<std::string> cells;
    for (std::size_t begin = 1; begin < line.size();) {
        const std::size_t end = std::min(line.find('|', begin), line.size());
        const std::string_view cell = line.substr(begin, end - begin);
        const std::size_t first = cell.find_first_not_of(' ');
        cells.emplace_back(first == std::string_view::npos ? "" : cell.substr(first, cell.find_last_not_of(' ') - first + 1));
        begin = end + 1;
    }
    return cells;
}

/// "`[rig]`: the nominal rig" and "key of `[study]`" name a table: "rig", "study"; others none.
std::string table_in(const std::string& text) {
    const std::size_t begin = text.find("`[");
    const std::size_t end = begin == std::string::npos ? begin : text.find("]`", begin);
    return end == std::string::npos ? "" : text.substr(begin + 2, end - begin - 2);
}

std::string without_quotes(std::string text) {
    std::erase(text, '`');
    return text;
}

/// The rows of a page whose first column names keys of a table; a row of two keys is two, each with its own default.
void add_keys(std::vector<FileKey>& keys, const char* file, std::string_view page) {
    for (const TableRow& row : table_rows(page)) {
        const bool is_experiment = row.head.front() == "experiment",
                   is_table = row.head.front() == "table" || row.head.front() == "whole key";
        const std::string in_head = table_in(row.head.front()), table = in_head.empty() ? table_in(row.section) : in_head;
        if (table.empty() && !is_experiment && !is_table) continue;
        const std::vector<std::string> names = core::pieces_of<std::string>(without_quotes(row.cells.front()), ", ");
        for (std::size_t k = 0; k < names.size(); ++k) {
            keys.push_back({file, is_experiment ? "experiments." + names[k] : is_table ? names[k] : table + "." + names[k], {}});
            for (std::size_t column = 1; column < std::min(row.head.size(), row.cells.size()); ++column) {
                if (row.cells[column].empty()) continue;
                const std::string cell = without_quotes(row.cells[column]);
                const std::vector<std::string> each = core::pieces_of<std::string>(cell, ", ");
                const bool own = row.head[column] == "default" && names.size() > 1 && each.size() == names.size();
                keys.back().lines.emplace_back(row.head[column], own ? each[k] : cell);
            }
        }
    }
}

}  // namespace

Entry key_entry(const profile::KeyInfo& key) {
    const std::string shipped = shipped_value(key.path), good = shipped.empty() ? key.default_value : shipped;
    const std::vector<std::string> rules = rules_of(key);
    Entry entry{"key", key.path, {}, {}};
    entry.json = {{"kind", "key"},
                  {"name", key.path},
                  {"meaning", key.meaning},
                  {"unit", key.unit},
                  {"allowed", key.allowed},
                  {"required", key.required},
                  {"default", key.required ? Json() : Json(key.default_value)},
                  {"only", key.when},
                  {"good", good.empty() ? Json() : Json(good)},
                  {"bad", key.refused.empty() ? Json() : Json(key.refused)},
                  {"needed_by", rules}};
    entry.lines = {{"means", key.meaning}, {"unit", key.unit.empty() ? "none" : key.unit}};
    entry.lines.emplace_back("default", key.required ? "none: it must be stated" : key.default_value);
    entry.lines.emplace_back("allowed", key.allowed);
    if (!key.when.empty()) entry.lines.emplace_back("applies", fmt::format("{}", fmt::join(key.when, ", ")));
    if (!good.empty())
        entry.lines.emplace_back("good", fmt::format("{} = {}{}", key.path, good, shipped.empty() ? "" : ", as in profiles/pnrvsa.toml"));
    if (!key.refused.empty()) entry.lines.emplace_back("bad", fmt::format("{} = {}", key.path, key.refused));
    if (!rules.empty()) entry.lines.emplace_back("rules that need it", fmt::format("{}", fmt::join(rules, ", ")));
    return entry;
}

std::vector<TableRow> table_rows(std::string_view page) {
    std::vector<TableRow> rows;
    TableRow row;
    for (const std::string_view line : core::pieces_of(page, "\n")) {
        if (line.starts_with("#")) row.section = line.substr(std::min(line.find(' ') + 1, line.size()));
        if (!line.starts_with("|")) row.head.clear();
        if (!line.starts_with("|") || line.starts_with("|---")) continue;
        row.cells = cells_of(line);
        if (row.head.empty())
            row.head = std::move(row.cells);
        else
            rows.push_back(row);
    }
    return rows;
}

std::string TableRow::cell(std::string_view column) const {
    const auto at = static_cast<std::size_t>(std::find(head.begin(), head.end(), column) - head.begin());
    return at < std::min(head.size(), cells.size()) ? cells[at] : std::string();
}

const std::vector<FileKey>& file_keys() {
    static const std::vector<FileKey> kKeys = [] {
        std::vector<FileKey> keys;
        add_keys(keys, "case.toml", kGapCases);
        add_keys(keys, "a study", kBatch);
        add_keys(keys, "case.toml of a model of one's own", kOwnModel);
        return keys;
    }();
    return kKeys;
}

Entry file_key_entry(const FileKey& key) {
    Entry entry{fmt::format("key of {}", key.file), key.path, {}, {{"kind", "key"}, {"name", key.path}, {"file", key.file}}};
    for (const auto& [label, text] : key.lines) {
        entry.lines.emplace_back(label == "meaning" ? "means" : label, text);
        entry.json[label] = text;
    }
    return entry;
}

}  // namespace fusee::app
