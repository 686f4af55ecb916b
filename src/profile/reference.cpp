#include <fmt/format.h>
#include <fmt/ranges.h>

#include <initializer_list>
#include <set>

#include "files.h"
#include "key.h"
#include "overrides.h"

namespace fusee::profile {

namespace {

/// One heading and its table; two parts with the same keys share one.
struct Section {
    std::string titles, first_table;
    std::vector<std::string> rows;
    std::vector<std::string> shared;  ///< names of the keys that stand in the table of K_SE
};

/// The default is read from the modules' options.
std::string default_text(const Key& key) {
    if (key.required) return "required";
    const Profile untouched = profile_for(key);
    if (key.kind == Kind::kNumber) return fmt::format("`{:.6g}`", key.unit.from_si(std::get<double>(key.get(untouched))));
    return "`" + toml_text(key, untouched) + "`";
}

/// The text without the first of these words with which it begins.
std::string without_prefix(std::string text, std::initializer_list<std::string_view> words) {
    for (const std::string_view first : words)
        if (text.starts_with(first)) return text.substr(first.size());
    return text;
}

std::string row(const Key& key) {
    std::string only;
    for (Condition when : key.when) {
        if ((when.key == "k_pe.family" && when.values.front() == "cable")) continue;  // stated at the family's key
        when.key = find_key(when.key)->leaf();
        only += fmt::format("{} {}", only.empty() ? "" : ",", without_prefix(when.text("`", "`"), {"only with ", "only "}));
    }
    if (!only.empty()) only = " (" + only.substr(1) + ")";
    return fmt::format("| `{}` | {} | {} | {}{} |\n", key.leaf(), without_prefix(allowed_text(key), {"a number, ", "an array of "}),
                       default_text(key), key.meaning, only);
}

/// @param paths of the keys to show
std::vector<Section> sections(const std::set<std::string>& paths) {
    std::vector<Section> all;
    for (const Key& key : keys()) {
        if (!paths.contains(key.path)) continue;
        const std::string table = key.table();
        if (all.empty() || all.back().first_table != table) all.push_back({fmt::format("`[{}]`", table), table, {}, {}});
        if (table.empty()) all.back().titles = "At the top";
        all.back().rows.push_back(row(key));
    }
    return all;
}

/// "k_se.spring" of "k_pe.spring"; empty for other tables
std::string table_of_k_se(const std::string& table) {
    for (const std::string part : {"k_pe", "cam"})
        if (table.starts_with(part)) return "k_se" + table.substr(part.size());
    return "";
}

/// A table of K_PE has only the rows that K_SE's table lacks; without any, K_SE's heading names both.
std::vector<Section> merged(const std::vector<Section>& all) {
    std::vector<Section> out;
    for (Section section : all) {
        const std::string other = table_of_k_se(section.first_table);
        const auto same = std::find_if(out.begin(), out.end(), [&](const Section& s) { return !other.empty() && s.first_table == other; });
        if (same != out.end())
            std::erase_if(section.rows, [&](const std::string& row) {
                if (std::find(same->rows.begin(), same->rows.end(), row) == same->rows.end()) return false;
                section.shared.push_back(row.substr(2, row.find(" | ", 2) - 2));
                return true;
            });
        if (same != out.end() && section.rows.empty() && section.shared.size() == same->rows.size())
            same->titles += ", " + section.titles;
        else
            out.push_back(section);
    }
    return out;
}

std::string text_of(const Section& section) {
    std::string text = fmt::format("### {}\n\n", section.titles);
    if (!section.shared.empty())
        text += fmt::format("As in `[{}]`: {}.\n\n", table_of_k_se(section.first_table), fmt::join(section.shared, ", "));
    if (section.rows.empty()) return text;
    return text + fmt::format("| key | allowed | default | meaning |\n|---|---|---|---|\n{}\n", fmt::join(section.rows, ""));
}

}  // namespace

std::string profile_reference(const std::vector<KeyInfo>& shown) {
    std::set<std::string> paths;
    for (const KeyInfo& key : shown) paths.insert(key.path);
    std::string text;
    for (const Section& section : merged(sections(paths))) text += text_of(section);
    return text;
}

std::string profile_reference() { return profile_reference(key_infos()) + columns_reference() + overrides_reference(); }

}  // namespace fusee::profile
