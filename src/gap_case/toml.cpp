#include "fusee/gap_case/toml.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <filesystem>

#include "fusee/core/lists.h"
#include "fusee/core/text.h"
#include "fusee/core/toml.h"

namespace fusee::gap_case {

namespace {

constexpr std::size_t kLargestToml = 1'000'000;  // bytes
constexpr std::size_t kLongestShown = 80;        // of a refused value

std::string leaf_of(const std::string& path) { return path.substr(path.rfind('.') + 1); }
std::string table_name_of(const std::string& path) { return path.substr(0, path.find('.') == std::string::npos ? 0 : path.rfind('.')); }

/// All cells of one type, or nothing.
template <class T>
std::optional<std::vector<T>> cells_of(const toml::array& array) {
    std::vector<T> cells;
    for (const toml::node& cell : array) {
        const auto value = cell.value<T>();
        if (!value) return std::nullopt;
        cells.push_back(*value);
    }
    return cells;
}

std::optional<CaseToml::Value> value_of(const toml::node& node) {
    if (const auto* text = node.as_string()) return text->get();
    if (node.is_number()) return node.value<double>().value();
    if (const auto* flag = node.as_boolean()) return flag->get();
    if (const auto* array = node.as_array()) {
        if (auto texts = cells_of<std::string>(*array)) return *texts;
        if (auto numbers = cells_of<double>(*array)) return *numbers;
    }
    return std::nullopt;
}

std::string shown(const CaseToml::Value& value) {
    struct Visitor {
        std::string operator()(double number) const { return fmt::format("{}", number); }
        std::string operator()(bool flag) const { return flag ? "true" : "false"; }
        std::string operator()(const std::string& text) const { return fmt::format("\"{}\"", text.substr(0, kLongestShown)); }
        std::string operator()(const std::vector<std::string>& texts) const { return fmt::format("an array of {} texts", texts.size()); }
        std::string operator()(const std::vector<double>& numbers) const { return fmt::format("an array of {} numbers", numbers.size()); }
    };
    return std::visit(Visitor{}, value);
}

std::string allowed_text(const NumberKey& key) {
    return fmt::format("a number{}{}, {:g} to {:g}{}{}{}", *key.unit == '\0' ? "" : " in ", key.unit, key.low, key.high,
                       *key.other == '\0' ? "" : "; is it in ", key.other, *key.other == '\0' ? "" : "?");
}

constexpr const char* kSpringsKey = "rig.springs";  // without them there is no rig

/// What to do about a file that is missing.
std::string not_found(const std::string& path, const std::string& name) {
    return name + (path == kSpringsKey ? " not found: restore it" : " not found: restore it or delete its line");
}

/// Is it the plain name of a file in the case's folder or below it?
bool is_inside(const std::string& name) {
    const fs::path file(name);
    return !name.empty() && !file.is_absolute() && std::find(file.begin(), file.end(), "..") == file.end();
}

/// "[rig], [columns]": without the tables below them.
std::string top_tables(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names)
        if (name.find('.') == std::string::npos) text += fmt::format("{}[{}]", text.empty() ? "" : ", ", name);
    return text;
}

}  // namespace

/// Flattens the parsed file; keeps toml++ out of the header.
struct CaseToml::Builder {
    CaseToml& to;

    void collect(const toml::table& table, const std::string& prefix) const {
        for (const auto& [name, node] : table) {
            const std::string path = prefix.empty() ? std::string(name.str()) : prefix + "." + std::string(name.str());
            const Place place{name.source().begin.line, name.source().begin.column};
            if (node.is_table()) {
                to.tables_[path] = place;
                collect(*node.as_table(), path);
                continue;
            }
            const std::optional<Value> value = value_of(node);
            to.leaves_[path] = {value.value_or(false), place};
            if (!value) throw to.fault(path, "another kind of value", "a number, a text or an array of one of them");
        }
    }

    /// The files of springs and [experiments] that are missing, all at once: a case that was moved lost them together.
    void require_files() const {
        core::Mistakes mistakes;
        for (const auto& [path, leaf] : to.leaves_) {
            if (path != kSpringsKey && !path.starts_with("experiments.")) continue;
            if (std::count(path.begin(), path.end(), '.') > 1 && leaf_of(path) != "files") continue;  // a simulator's experiment is a table
            std::vector<std::string> names;
            if (const auto* text = std::get_if<std::string>(&leaf.value)) names = {*text};
            if (const auto* texts = std::get_if<std::vector<std::string>>(&leaf.value)) names = *texts;
            for (const std::string& name : names)
                if (is_inside(name) && !to.source_.has(name)) mistakes.add(to.fault(path, not_found(path, name), ""));
        }
        mistakes.throw_if_any();
    }
};

CaseToml::CaseToml(const CaseFiles& files, const std::string& file)
    : source_(files), file_((files.folder() / file).string()), bytes_(files.read(file, kLargestToml)) {
    const Builder builder{*this};
    builder.collect(core::parse_toml(bytes_, file_), "");
    builder.require_files();
}

core::InvalidInput CaseToml::fault(const std::string& path, std::string value, std::string allowed) const {
    Place place;
    if (const auto leaf = leaves_.find(path); leaf != leaves_.end())
        place = leaf->second.place;
    else if (const auto table = tables_.find(tables_.contains(path) ? path : table_name_of(path)); table != tables_.end())
        place = table->second;
    return {fmt::format("{}:{}:{}: {}", file_, place.line, place.column, path), std::move(value), std::move(allowed)};
}

void CaseToml::allow_tables(const std::vector<std::string>& names) const {
    for (const auto& [path, place] : tables_)
        if (std::find(names.begin(), names.end(), path) == names.end())
            throw fault(path, "unknown table", top_tables(names) + core::did_you_mean(path, names));
    for (const auto& [path, leaf] : leaves_)
        if (path.find('.') == std::string::npos) throw fault(path, "unknown key", "keys stand below a table: " + top_tables(names));
}

std::vector<std::string> CaseToml::keys_of(const std::string& table) const {
    std::vector<std::string> keys;
    for (const auto& [path, leaf] : leaves_)
        if (table_name_of(path) == table) keys.push_back(leaf_of(path));
    return keys;
}

std::vector<std::string> CaseToml::tables_below(const std::string& table) const {
    std::vector<std::string> names;
    for (const auto& [path, place] : tables_)
        if (table_name_of(path) == table) names.push_back(leaf_of(path));
    return names;
}

void CaseToml::read_number(const std::string& path, const NumberKey& key) const {
    const Value& value = at(path);
    const double* number = std::get_if<double>(&value);
    // NaN fails both comparisons.
    if (number == nullptr || !(*number >= key.low && *number <= key.high)) throw fault(path, shown(value), allowed_text(key));
    *key.to = *number;
}

std::vector<std::string> CaseToml::read_numbers(const std::string& table, const std::vector<NumberKey>& keys,
                                                const std::vector<std::string>& others) const {
    std::vector<std::string> known = others, lacking;
    for (const NumberKey& key : keys) known.push_back(key.name);
    for (const std::string& key : keys_of(table))
        if (std::find(known.begin(), known.end(), key) == known.end())
            throw fault(table + "." + key, "unknown key", fmt::format("{}{}", fmt::join(known, ", "), core::did_you_mean(key, known)));
    for (const NumberKey& key : keys) {
        const std::string path = table + "." + key.name;
        has(path) ? read_number(path, key) : lacking.push_back(key.name);
    }
    return lacking;
}

void CaseToml::require_numbers(const std::string& table, const std::vector<NumberKey>& keys, const std::vector<std::string>& others) const {
    core::Mistakes mistakes;
    for (const std::string& name : read_numbers(table, keys, others)) {
        mistakes.add(fault(table + "." + name, "missing", allowed_text(*core::find_by(keys, &NumberKey::name, name))));
    }
    mistakes.throw_if_any();
}

std::string CaseToml::text(const std::string& path, const std::string& allowed) const {
    if (!has(path)) throw fault(path, "missing", allowed);
    const std::string* text = std::get_if<std::string>(&at(path));
    if (text == nullptr || text->empty()) throw fault(path, shown(at(path)), allowed);
    return *text;
}

std::vector<std::string> CaseToml::files(const std::string& path) const {
    static const std::string kAllowed = "the name of a CSV file in the case's folder, or an array of such names";
    if (!has(path)) throw fault(path, "missing", kAllowed);
    std::vector<std::string> names;
    if (const auto* many = std::get_if<std::vector<std::string>>(&at(path)))
        names = *many;
    else
        names = {text(path, kAllowed)};
    if (names.empty()) throw fault(path, "an empty array", kAllowed);
    for (const std::string& name : names) check_file(path, name);
    return names;
}

void CaseToml::check_file(const std::string& path, const std::string& name) const {
    if (!is_inside(name)) throw fault(path, fmt::format("\"{}\"", name), "a file inside the case's folder");
    if (!source_.has(name)) throw fault(path, not_found(path, name), "");
    std::vector<std::string> same;
    const auto compare = [&](const std::string& other) {
        if (source_.same(other, name)) same.push_back('"' + other + '"');
    };
    for (const auto& [other, leaf] : leaves_) {
        if (const auto* text = std::get_if<std::string>(&leaf.value)) compare(*text);
        if (const auto* texts = std::get_if<std::vector<std::string>>(&leaf.value)) std::for_each(texts->begin(), texts->end(), compare);
    }
    if (same.size() > 1) throw fault(path, fmt::format("{}", fmt::join(same, " and ")), "a file of its own: this one is named twice");
}

}  // namespace fusee::gap_case
