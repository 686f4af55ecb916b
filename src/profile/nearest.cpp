#include <array>
#include <tuple>

#include "fusee/core/text.h"
#include "key.h"

namespace fusee::profile {

namespace {

using core::edit_distance;

constexpr std::size_t kLongestCompared = 100;  // letters: known paths have less than half as many

/// The name without its unit, so that "lead_in_rad" finds "lead_in_deg" before any name with similar spelling.
std::string_view stem(std::string_view name) {
    static constexpr std::array kUnits{"m",   "cm",  "mm",  "um",      "in",   "inch", "deg",  "rad",    "Nm",  "nm",
                                       "mNm", "Ncm", "kN",  "N",       "Pa",   "kPa",  "MPa",  "GPa",    "per", "J",
                                       "psi", "lbf", "mpa", "degrees", "kgm2", "Nms",  "Nm2s", "percent"};
    while (true) {
        const auto cut = name.rfind('_');
        if (cut == std::string_view::npos) return name;
        if (std::find(kUnits.begin(), kUnits.end(), name.substr(cut + 1)) == kUnits.end()) return name;
        name = name.substr(0, cut);
    }
}

/// Distance of two names without their units; a name that extends the other counts as one letter: "shrink" finds "shrink_x".
std::size_t stem_distance(std::string_view asked, std::string_view known) {
    constexpr std::size_t kLeast = 4;  // letters that identify a name
    const std::string_view a = stem(asked), b = stem(known);
    const bool begins = std::min(a.size(), b.size()) >= kLeast && (a.starts_with(b) || b.starts_with(a));
    return begins && a != b ? 1 : edit_distance(a, b);
}

std::pair<std::string_view, std::string_view> split(std::string_view path) {
    const auto dot = path.rfind('.');
    return dot == std::string_view::npos ? std::pair{std::string_view{}, path} : std::pair{path.substr(0, dot), path.substr(dot + 1)};
}

}  // namespace

const Key& nearest_key(std::string_view path, const Profile* profile) {
    path = path.substr(0, kLongestCompared);
    const auto [table, leaf] = split(path);
    const auto cost = [table = table, leaf = leaf, profile](const Key& key) {
        const auto [known_table, known_leaf] = split(key.path);
        return std::tuple(profile != nullptr && !is_of(key, *profile), edit_distance(table, known_table) + stem_distance(leaf, known_leaf),
                          edit_distance(leaf, known_leaf));
    };
    return *std::min_element(keys().begin(), keys().end(), [&](const Key& a, const Key& b) { return cost(a) < cost(b); });
}

std::string nearest_table(std::string_view path, const Profile& profile) {
    path = path.substr(0, kLongestCompared);
    std::vector<std::string> tables;
    for (const Key& key : keys())
        for (std::string table = is_of(key, profile) ? key.table() : ""; !table.empty(); table = std::string(split(table).first))
            tables.push_back(table);
    return *std::min_element(tables.begin(), tables.end(), [path](const std::string& a, const std::string& b) {
        return edit_distance(path, a) < edit_distance(path, b);
    });
}

const checks::RuleInfo& nearest_rule(std::string_view id, const RuleInfos& rules) {
    id = id.substr(0, kLongestCompared);
    return **std::min_element(rules.begin(), rules.end(), [id](const checks::RuleInfo* a, const checks::RuleInfo* b) {
        return edit_distance(id, a->id) < edit_distance(id, b->id);
    });
}

}  // namespace fusee::profile
