#include "key.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>

namespace fusee::profile {

namespace {

constexpr int kMostDigits = 17;  // any double survives 17 significant digits

std::string shortest(double si, const Unit& unit) {
    double value = 0.0;
    for (int digits = 1; digits <= kMostDigits; ++digits) {
        const std::string text = fmt::format("{:.{}g}", unit.from_si(si), digits);
        std::from_chars(text.data(), text.data() + text.size(), value);
        if (unit.to_si(value) == si) break;
    }
    return fmt::format("{}", value);
}

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        if (static_cast<unsigned char>(c) < 0x20)
            out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        else
            out += c;
    }
    return out + '"';
}

std::vector<std::string> quoted(const std::vector<std::string>& texts) {
    std::vector<std::string> out;
    for (const std::string& text : texts) out.push_back(quoted(text));
    return out;
}

std::string range_text(const Limits& limits, const Unit& unit) {
    const std::string name = unit.name;
    return fmt::format("{}{}",
                       limits.low_allowed ? fmt::format("{:g} to {:g}", limits.low, limits.high)
                                          : fmt::format("above {:g}, at most {:g}", limits.low, limits.high),
                       name.empty() ? "" : " " + name);
}

std::string count_text(const Key& key) {
    if (key.least_count == key.most_count) return fmt::format("{}", key.least_count);
    return fmt::format("{} to {}", key.least_count, key.most_count);
}

}  // namespace

std::string Key::table() const {
    const auto dot = path.rfind('.');
    return dot == std::string::npos ? "" : path.substr(0, dot);
}

std::string Key::leaf() const { return path.substr(path.rfind('.') + 1); }

const Key* find_key(std::string_view path) {
    for (const Key& key : keys())
        if (key.path == path) return &key;
    return nullptr;
}

bool is_table(std::string_view path) {
    const std::string prefix = std::string(path) + ".";
    return std::any_of(keys().begin(), keys().end(), [&](const Key& key) { return key.path.starts_with(prefix); });
}

bool applies(const Key& key, const Profile& profile) {
    if (key.when.key.empty()) return true;
    const std::string now = std::get<std::string>(find_key(key.when.key)->get(profile));
    return std::find(key.when.values.begin(), key.when.values.end(), now) != key.when.values.end();
}

std::string allowed_text(const Key& key) {
    switch (key.kind) {
        case Kind::kNumber:
            return "a number, " + range_text(key.limits, key.unit);
        case Kind::kInteger:
            return "a whole number, " + range_text(key.limits, key.unit);
        case Kind::kName:
            return "a text of 1 to 64 letters, digits, '.', '_' or '-', beginning with a letter or digit";
        case Kind::kFile:
            return "a file name as text";
        case Kind::kChoice:
            return fmt::format("{}", fmt::join(quoted(key.choices), " or "));
        case Kind::kSign:
            return "1 or -1";
        case Kind::kNumbers:
            return fmt::format("an array of {} numbers, each {}", count_text(key), range_text(key.limits, key.unit));
        case Kind::kChoices:
            return fmt::format("an array of {} different ones of {}", count_text(key), fmt::join(quoted(key.choices), ", "));
    }
    return "";
}

std::string toml_text(const Key& key, const Profile& profile) {
    const Value value = key.get(profile);
    if (const auto* number = std::get_if<double>(&value)) return shortest(*number, key.unit);
    if (const auto* whole = std::get_if<int>(&value)) return fmt::format("{}", *whole);
    if (const auto* text = std::get_if<std::string>(&value)) return quoted(*text);
    if (const auto* texts = std::get_if<std::vector<std::string>>(&value)) return fmt::format("[{}]", fmt::join(quoted(*texts), ", "));
    std::vector<std::string> cells;
    for (const double number : std::get<std::vector<double>>(value)) cells.push_back(shortest(number, key.unit));
    return fmt::format("[{}]", fmt::join(cells, ", "));
}

}  // namespace fusee::profile
