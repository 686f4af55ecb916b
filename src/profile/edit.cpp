#include "fusee/profile/edit.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <sstream>

#include "fusee/core/error.h"
#include "fusee/core/lists.h"
#include "fusee/core/text.h"
#include "key.h"

namespace fusee::profile {

namespace {

std::string line_end(const std::string& toml) { return toml.find("\r\n") != std::string::npos ? "\r\n" : "\n"; }

/// First byte of a line, counted from 1; the text's end if there are fewer.
std::size_t line_begin(const std::string& toml, std::size_t line) {
    std::size_t at = toml.starts_with(core::kByteOrderMark) ? core::kByteOrderMark.size() : 0;
    for (; line > 1 && at < toml.size(); --line) at = std::min(toml.find('\n', at), toml.size() - 1) + 1;
    return at;
}

std::size_t place_of(const std::string& toml, const toml::source_position& at) { return line_begin(toml, at.line) + at.column - 1; }

/// One past the end of the number, one-line text or flat array that begins at `begin`.
std::size_t value_end(const std::string& toml, std::size_t begin) {
    const char quote = toml[begin];
    if (quote == '[') return std::min(toml.find(']', begin), toml.size() - 1) + 1;
    if (quote != '"' && quote != '\'') return std::min(toml.find_first_of(" \t\r\n,}#", begin), toml.size());
    std::size_t end = begin + 1;
    while (end < toml.size() && toml[end] != quote) end += quote == '"' && toml[end] == '\\' ? 2 : 1;
    return std::min(end + 1, toml.size());
}

std::string comment(const Key& key, const Edit& edit, const std::string& end) {
    return edit.why.empty() ? "" : fmt::format("# {} was {}: {}{}", key.leaf(), edit.was, edit.why, end);
}

/// Replaces the comment behind the old value. What follows the value in an inline table stays.
void replace_comment(std::string& toml, std::size_t value_end, const std::string& origin) {
    const std::size_t at = toml.find_first_not_of(" \t", value_end);
    if (at == std::string::npos || toml[at] != '#') return;
    toml.replace(at, std::min(toml.find_first_of("\r\n", at), toml.size()) - at, "# " + origin);
}

/// Is this the line "[k_se.spring]"?
bool is_heading(const std::string& toml, std::size_t at, const std::string& table) {
    return toml.compare(at, table.size() + 2, "[" + table + "]") == 0;
}

void add_key(std::string& toml, const toml::table& parsed, const Key& key, const Edit& edit) {
    const std::string end = line_end(toml), line = comment(key, edit, end) + key.leaf() + " = " + edit.value + end;
    const toml::node_view<const toml::node> table = parsed.at_path(key.table());
    if (table.is_table()) {
        const std::size_t heading = place_of(toml, table.node()->source().begin);
        if (is_heading(toml, heading, key.table())) {
            if (toml.find('\n', heading) == std::string::npos) toml += end;
            toml.insert(toml.find('\n', heading) + 1, line);
            return;
        }
    }
    if (!toml.ends_with('\n')) toml += end;
    toml += end + "[" + key.table() + "]" + end + line;
}

/// The key with its value and, on a line of its own, its comment; in an inline table with one comma.
void cut_out(std::string& toml, std::size_t begin, std::size_t end) {
    const std::size_t line = toml.rfind('\n', begin) + 1;  // 0 if there is none
    const std::size_t comma = toml.find_last_of("{,", begin);
    if (comma == std::string::npos || comma < line) {  // not in an inline table
        const std::size_t line_end = toml.find('\n', end);
        toml.erase(line, line_end == std::string::npos ? line_end : line_end + 1 - line);
        return;
    }
    std::size_t next = std::min(toml.find_first_not_of(" \t", end), toml.size());
    const bool last = toml[next] != ',', first = toml[comma] == '{';
    if (!last) next = toml.find_first_not_of(" \t", next + 1);
    const std::size_t from = last && !first ? comma : toml.find_first_not_of(" \t", comma + 1);
    toml.erase(from, (last ? end : next) - from);
}

void make(std::string& toml, const Key& key, const Edit& edit) {
    const toml::table parsed = toml::parse(toml);
    const toml::node_view<const toml::node> node = parsed.at_path(key.path);
    if (!node) return edit.value.empty() ? void() : add_key(toml, parsed, key, edit);
    const toml::source_position at = node.node()->source().begin;
    const std::size_t begin = place_of(toml, at), end = value_end(toml, begin);
    if (edit.value.empty()) {
        cut_out(toml, begin, end);
        toml.insert(line_begin(toml, at.line), comment(key, edit, line_end(toml)));
        return;
    }
    if (!edit.origin.empty()) replace_comment(toml, end, edit.origin);
    toml.replace(begin, end - begin, edit.value);
    toml.insert(line_begin(toml, at.line), comment(key, edit, line_end(toml)));
}

/// The edits' value of a text key; none if they do not change it.
std::optional<std::string> chosen(const std::string& key, const std::vector<Edit>& edits) {
    for (const Edit& edit : edits)
        if (edit.key == key && edit.value.size() >= 2 && edit.value.front() == '"') return edit.value.substr(1, edit.value.size() - 2);
    return std::nullopt;
}

/// Keys of the file that no longer apply after the edits, with their failed condition.
std::vector<std::pair<const Key*, Condition>> without_meaning(const Profile& profile, const std::vector<Edit>& edits) {
    std::vector<std::pair<const Key*, Condition>> all;
    for (const Key& key : keys()) {
        if (!profile.places.contains(key.path)) continue;
        for (const Condition& when : key.when) {
            const auto value = chosen(when.key, edits);
            if (!value || std::find(when.values.begin(), when.values.end(), *value) != when.values.end()) continue;
            all.emplace_back(&key, when);
            break;
        }
    }
    return all;
}

/// Makes the key's line a comment. @throws InvalidInput if the line has other keys
void comment_out(std::string& toml, const Profile& profile, const Key& key, const Condition& when) {
    const toml::table parsed = toml::parse(toml);
    const toml::node_view<const toml::node> node = parsed.at_path(key.path);
    if (!node) return;
    const std::size_t begin = line_begin(toml, node.node()->source().begin.line), leaf = toml.find_first_not_of(" \t", begin);
    if (!toml.substr(leaf).starts_with(key.leaf()))
        throw core::InvalidInput(profile.place_of(key.path), "is in a line with other keys",
                                 fmt::format("a separate line, which can be removed: {}", when.text("", "\"")));
    toml.insert(begin, fmt::format("# {}: ", when.text("", "\"")));
}

/// Is the new value the only change of the text?
bool holds(const std::string& toml, const Key& key, const Edit& edit) {
    try {
        if (edit.value.empty()) return !toml::parse(toml).at_path(key.path);
        const toml::table parsed = toml::parse(toml), wanted = toml::parse("value = " + edit.value);
        const toml::node_view<const toml::node> node = parsed.at_path(key.path);
        std::ostringstream found, asked;
        if (node) found << node;
        asked << wanted["value"];
        return found.str() == asked.str();
    } catch (const toml::parse_error&) {
        return false;
    }
}

}  // namespace

std::vector<std::string> key_names() { return core::each<std::string>(keys(), &Key::path); }

void require_key(const std::string& field, const std::string& key) {
    if (find_key(key) == nullptr && !is_table(key))
        throw core::InvalidInput(field, key, fmt::format("a key of a profile; nearest known one: {}", nearest_key(key).path));
}

std::string counterpart(const std::string& key, const Profile& profile) {
    const std::size_t dot = std::min(key.find('.'), key.size());
    const std::string part = key.substr(0, dot), rest = key.substr(dot);
    if (!(profile.is_spring() ? part == "k_se" || part == "k_pe" : part == "cam")) return "";
    for (const char* own : {"cam", "k_pe", "k_se"})
        if (own != part && value_text(profile, own + rest)) return own + rest;
    return "";
}

bool names_file(const std::string& path) {
    const Key* key = find_key(path);
    return key != nullptr && key->kind == Kind::kFile;
}

double number_of(const Profile& profile, const std::string& key) { return std::get<double>(find_key(key, profile)->get(profile)); }

std::optional<std::string> value_text(const Profile& profile, const std::string& path) {
    const Key* key = find_key(path, profile);
    return key != nullptr && applies(*key, profile) ? std::optional(toml_text(*key, profile)) : std::nullopt;
}

void set_number(Profile& profile, const std::string& key, double value) { find_key(key, profile)->set(profile, value); }

Edit number_edit(const Profile& profile, const std::string& path, double value, std::string why) {
    const Key& key = *find_key(path, profile);
    return {{path, core::number(key.unit.from_si(value)), toml_text(key, profile)}, std::move(why)};
}

Edit text_edit(const Profile& profile, const std::string& path, const std::string& value, std::string why) {
    const Key& key = *find_key(path, profile);
    Profile changed = profile;
    key.set(changed, value);
    return {{path, toml_text(key, changed), toml_text(key, profile)}, std::move(why)};
}

std::string derived_name(const std::string& name, const std::string& ending) {
    const std::size_t at = name.rfind(ending);
    const std::string behind = at == std::string::npos ? "" : name.substr(at + ending.size());
    const bool numbered =
        behind.size() > 1 && behind.size() < 8 && behind.front() == '-' && behind.find_first_not_of("0123456789", 1) == std::string::npos;
    const bool again = at != std::string::npos && at > 0 && (behind.empty() || numbered);
    const std::string last = again ? fmt::format("{}-{}", ending, numbered ? std::stol(behind.substr(1)) + 1 : 2) : ending;
    return name.substr(0, std::min(again ? at : name.size(), kLongestName - last.size())) + last;
}

Edit name_edit(const Profile& profile, const std::string& ending) {
    return text_edit(profile, "name", derived_name(profile.name, ending), "");
}

std::vector<Edit> file_edits(const Profile& profile, const fs::path& folder) {
    const fs::path from = fs::absolute(profile.file).parent_path(), to = fs::absolute(folder);
    std::vector<Edit> edits;
    if (fs::weakly_canonical(from) == fs::weakly_canonical(to)) return edits;
    for (const Key& key : keys()) {
        if (key.kind != Kind::kFile || !applies(key, profile)) continue;
        const std::string file = std::get<std::string>(key.get(profile));
        if (file.empty() || fs::path(file).is_absolute()) continue;
        edits.push_back(text_edit(profile, key.path, fs::relative(from / file, to).generic_string(), ""));
    }
    return edits;
}

std::string with_edits(std::string toml, const Profile& profile, const std::vector<Edit>& edits, const std::string& head) {
    for (const Edit& edit : edits) {
        const Key& key = *find_key(edit.key);
        make(toml, key, edit);
        if (!holds(toml, key, edit))
            throw core::InvalidInput(
                profile.place_of(edit.key), "its table is inline or uses dotted keys",
                fmt::format("a heading [{}] with one key per line, so that {} can be added below it", key.table(), key.leaf()));
    }
    for (const auto& [key, when] : without_meaning(profile, edits)) comment_out(toml, profile, *key, when);
    return toml.insert(line_begin(toml, 1), head.empty() ? "" : head + line_end(toml));
}

}  // namespace fusee::profile
