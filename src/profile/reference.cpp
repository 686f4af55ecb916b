#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

#include "files.h"
#include "fusee/profile/keys.h"
#include "key.h"
#include "overrides.h"

namespace fusee::profile {

namespace {

/// One heading and its table; two parts with the same keys share one.
struct Section {
    std::string titles, body, first_table;
};

/// The default is read from the modules' options.
std::string default_text(const Key& key) {
    if (key.required) return "required";
    Profile untouched;
    for (const Condition& when : key.when) find_key(when.key)->set(untouched, when.values.front());
    if (key.kind == Kind::kNumber) return fmt::format("`{:.6g}`", key.unit.from_si(std::get<double>(key.get(untouched))));
    return "`" + toml_text(key, untouched) + "`";
}

std::string row(const Key& key) {
    std::string only;
    for (Condition when : key.when) {
        if (when.key == "k_pe.family" && when.values.front() == "cable") continue;  // stated at the family's key
        when.key = find_key(when.key)->leaf();
        only += fmt::format("{} {}", only.empty() ? "" : ",", when.text("`", "`"));
    }
    if (!only.empty()) only = " (" + only.substr(1) + ")";
    return fmt::format("| `{}` | {} | {} | {}{} |\n", key.leaf(), allowed_text(key), default_text(key), key.meaning, only);
}

/// @param paths of the keys to show
std::vector<Section> sections(const std::set<std::string>& paths) {
    std::vector<Section> all;
    for (const Key& key : keys()) {
        if (!paths.contains(key.path)) continue;
        const std::string table = key.table();
        if (all.empty() || all.back().first_table != table) all.push_back({fmt::format("`[{}]`", table), "", table});
        if (table.empty()) all.back().titles = "At the top";
        all.back().body += row(key);
    }
    return all;
}

/// Joins the k_pe table to the k_se table of the same content.
std::vector<Section> merged(const std::vector<Section>& all) {
    std::vector<Section> out;
    for (const Section& section : all) {
        const auto same = std::find_if(out.begin(), out.end(), [&](const Section& s) {
            return s.first_table.starts_with("k_") && section.first_table.starts_with("k_") && s.body == section.body;
        });
        if (same == out.end())
            out.push_back(section);
        else
            same->titles += ", " + section.titles;
    }
    return out;
}

}  // namespace

std::string profile_reference(const std::vector<KeyInfo>& shown) {
    std::set<std::string> paths;
    for (const KeyInfo& key : shown) paths.insert(key.path);
    std::string text;
    for (const Section& section : merged(sections(paths)))
        text += fmt::format("### {}\n\n| key | allowed | default | meaning |\n|---|---|---|---|\n{}\n", section.titles, section.body);
    return text;
}

std::string profile_reference() { return profile_reference(key_infos()) + columns_reference() + overrides_reference(); }

}  // namespace fusee::profile
