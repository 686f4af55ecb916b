#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <string_view>

#include "explain/entry.h"
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

}  // namespace fusee::app
