#include "fusee/core/json.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "fusee/core/error.h"
#include "fusee/core/file.h"

namespace fusee::core {

namespace {

using Json = nlohmann::ordered_json;
constexpr std::size_t kLongestShown = 80;  // of a refused value

/// The caller's mistake at a byte of the text.
InvalidInput fault(std::string_view bytes, const std::string& file, std::size_t at, std::string value, std::string allowed) {
    const std::string_view before = bytes.substr(0, std::min(at, bytes.size()));
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t column = before.size() - (before.find_last_of('\n') + 1) + 1;  // npos + 1 is 0
    return {fmt::format("{}:{}:{}: JSON", file, line, column), std::move(value), std::move(allowed)};
}

/// Runs before the parser: deep nesting may overflow the stack of recursive code.
void require_shallow(std::string_view bytes, const std::string& file) {
    std::size_t depth = 0;
    bool inside_text = false;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const char c = bytes[i];
        if (inside_text) {
            if (c == '\\') ++i;
            if (c == '"') inside_text = false;
        } else if (c == '"') {
            inside_text = true;
        } else if (c == '[' || c == '{') {
            if (++depth > kDeepestJson)
                throw fault(bytes, file, i, fmt::format("nested {} deep or more", depth), fmt::format("at most {} deep", kDeepestJson));
        } else if ((c == ']' || c == '}') && depth > 0) {
            --depth;
        }
    }
}

/// The number that the parser found too large, from its message "... parsing '1e400'".
std::string number_in(const std::string& message) {
    const std::size_t end = message.rfind('\''), begin = end == 0 ? end : message.rfind('\'', end - 1);
    return end == std::string::npos || begin == std::string::npos ? "" : message.substr(begin + 1, end - begin - 1);
}

std::string shortened(const Json& json) {
    const std::string all = json.dump(-1, ' ', true, Json::error_handler_t::replace);
    return all.size() <= kLongestShown ? all : all.substr(0, kLongestShown) + "...";
}

/// Adds the old name next to the new one in `json` and its children. @returns whether the new name was found
bool add_old_name(Json& json, const std::string& before, const std::string& now) {
    bool found = false;
    for (Json& child : json) found |= child.is_structured() && add_old_name(child, before, now);
    if (!json.is_object() || !json.contains(now)) return found;
    json[before] = Json(json[now]);
    return true;
}

}  // namespace

nlohmann::ordered_json parse_json(std::string_view bytes, const std::string& file) {
    require_shallow(bytes, file);
    try {
        return Json::parse(bytes);
    } catch (const Json::parse_error& e) {
        throw fault(bytes, file, e.byte > 0 ? e.byte - 1 : 0, "not valid JSON", "JSON by RFC 8259");
    } catch (const Json::out_of_range& e) {
        const std::string number = number_in(e.what());
        throw fault(bytes, file, bytes.find(number), number.substr(0, kLongestShown),
                    fmt::format("a number of at most {:.4g}", std::numeric_limits<double>::max()));
    }
}

nlohmann::ordered_json read_json(const std::filesystem::path& path) {
    constexpr std::size_t kLargest = std::size_t{1} << 30;  // bytes
    return parse_json(read_file(path, kLargest), path.string());
}

JsonNode JsonNode::of_file(const nlohmann::ordered_json& json, const std::string& file) {
    JsonNode node(json, file);
    node.file_ = true;
    return node;
}

std::string JsonNode::path_to(const std::string& key) const { return path_ + (file_ ? ": " : ".") + key; }

bool JsonNode::has(const std::string& key) const { return json_.is_object() && json_.contains(key); }
bool JsonNode::is_null() const { return json_.is_null(); }
bool JsonNode::is_text() const { return json_.is_string(); }

JsonNode JsonNode::operator[](const std::string& key) const {
    if (!json_.is_object()) refuse("an object");
    if (!json_.contains(key)) throw InvalidInput(path_to(key), "missing", "this key");
    return {json_.at(key), path_to(key)};
}

std::string JsonNode::text() const {
    if (!json_.is_string()) refuse("a text");
    return json_.get<std::string>();
}

std::string JsonNode::one_of(const std::vector<std::string>& allowed) const {
    std::string value = text();
    if (std::find(allowed.begin(), allowed.end(), value) == allowed.end()) refuse(fmt::format("{}", fmt::join(allowed, ", ")));
    return value;
}

double JsonNode::number() const {
    if (!json_.is_number()) refuse("a number");
    return json_.get<double>();
}

double JsonNode::number_or_null() const { return json_.is_null() ? std::numeric_limits<double>::quiet_NaN() : number(); }

double JsonNode::number_within(double low, double high) const {
    const double value = number();
    if (!(value >= low && value <= high)) refuse(fmt::format("{:g} to {:g}", low, high));
    return value;
}

double JsonNode::number_at_least(double low) const {
    const double value = number();
    if (!(value >= low)) refuse(fmt::format("at least {:g}", low));
    return value;
}

int JsonNode::sign() const {
    const double value = number();
    if (std::abs(value) != 1.0) refuse("1 or -1");
    return static_cast<int>(value);
}

std::size_t JsonNode::count() const {
    if (!json_.is_number_unsigned()) refuse("a whole number, at least 0");
    return json_.get<std::size_t>();
}

void JsonNode::copy_numbers(double* numbers, std::size_t count) const {
    const std::vector<JsonNode> all = cells();
    if (all.size() != count) refuse(fmt::format("{} numbers", count));
    for (const JsonNode& cell : all) *numbers++ = cell.number();
}

std::vector<JsonNode> JsonNode::cells(std::size_t least) const {
    if (!json_.is_array()) refuse("an array");
    if (json_.size() < least) refuse(fmt::format("an array of at least {}", least));
    std::vector<JsonNode> cells;
    for (std::size_t i = 0; i < json_.size(); ++i) cells.emplace_back(json_[i], fmt::format("{}[{}]", path_, i));
    return cells;
}

std::vector<std::pair<std::string, JsonNode>> JsonNode::members() const {
    if (!json_.is_object()) refuse("an object");
    std::vector<std::pair<std::string, JsonNode>> members;
    for (const auto& [key, value] : json_.items()) members.emplace_back(key, JsonNode(value, path_to(key)));
    return members;
}

void JsonNode::allow_keys(const std::vector<std::string>& known) const {
    for (const auto& [key, node] : members())
        if (std::find(known.begin(), known.end(), key) == known.end())
            throw InvalidInput(node.path(), "unknown key", fmt::format("{}", fmt::join(known, ", ")));
}

void JsonNode::refuse(const std::string& allowed) const { throw InvalidInput(path_, shortened(json_), allowed); }

void keep_old_spelling(nlohmann::ordered_json& json, const std::vector<std::pair<std::string, std::string>>& renamed) {
    Json names = Json::object();
    for (const auto& [before, now] : renamed)
        if (add_old_name(json, before, now)) names[before] = now;
    if (!names.empty()) json["renamed_fields"] = names;
}

}  // namespace fusee::core
