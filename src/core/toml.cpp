#include "fusee/core/toml.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>
#include <utility>

#include "fusee/core/text.h"

namespace fusee::core {

namespace {

constexpr int kDeepestToml = 32;  // nested brackets, and names in a dotted key: settings need 4; the parser recurses for each

/// Skips comments and strings; everything else is syntax. @throws IoError with line and column
class Scanner {
public:
    Scanner(std::string_view text, const std::string& file) : text_(text), file_(file) {
        if (text_.starts_with(kByteOrderMark)) at_ = line_start_ = kByteOrderMark.size();
    }

    void check() {
        while (at_ < text_.size()) {
            if (static_cast<unsigned char>(text_[at_]) >= 0x80)
                refuse("a character outside ASCII; such characters are allowed only in comments and quoted texts");
            count_depth(text_[at_]);
            if (text_[at_] == '#')
                skip_comment();
            else if (text_[at_] == '"' || text_[at_] == '\'')
                skip_string(text_[at_]);
            else
                step();
        }
    }

private:
    [[noreturn]] void refuse(const std::string& why) const {
        throw IoError(fmt::format("{}:{}:{}", file_, line_, at_ - line_start_ + 1), why);
    }
    void count_depth(char c) {
        if (c == '[' || c == '{') ++brackets_;
        if (c == ']' || c == '}') brackets_ = std::max(0, brackets_ - 1);
        if (std::string_view("=,[]{}\n").find(c) != std::string_view::npos) dots_ = 0;  // another name or value begins
        if (c == '.') ++dots_;
        if (brackets_ > kDeepestToml || dots_ >= kDeepestToml)
            refuse(fmt::format("not valid TOML for fusee: more than {} {}", kDeepestToml,
                               dots_ > 0 ? "names in a dotted key" : "nested brackets"));
    }
    void step() {
        if (text_[at_++] != '\n') return;
        ++line_;
        line_start_ = at_;
    }
    void skip_comment() {
        while (at_ < text_.size() && text_[at_] != '\n') step();
    }
    void skip_string(char quote) {
        const std::string triple(3, quote);
        const bool many_lines = text_.substr(at_).starts_with(triple);
        const std::string end = many_lines ? triple : triple.substr(0, 1);
        for (std::size_t i = 0; i < end.size(); ++i) step();
        while (at_ < text_.size() && !text_.substr(at_).starts_with(end)) {
            if (text_[at_] == '\n' && !many_lines) return;  // an unclosed string: the parser reports it
            if (quote == '"' && text_[at_] == '\\' && at_ + 1 < text_.size()) step();
            step();
        }
        for (std::size_t i = 0; i < end.size() && at_ < text_.size(); ++i) step();
    }

    std::string_view text_;
    const std::string& file_;
    std::size_t at_ = 0, line_ = 1, line_start_ = 0;
    int brackets_ = 0, dots_ = 0;
};

/// A control character that begins with 0xC2 has two bytes.
std::string control_shown(const std::string& text, std::size_t at) { return printable(text.substr(at, text[at] == '\xC2' ? 2 : 1)); }

/// TOML texts may contain any character, as in "\u001b".
void require_plain_texts(const toml::node& node, const std::string& file) {
    if (const auto* table = node.as_table())
        for (const auto& [key, value] : *table) require_plain_texts(value, file);
    if (const auto* array = node.as_array())
        for (const toml::node& cell : *array) require_plain_texts(cell, file);
    const auto* text = node.as_string();
    const std::size_t at = text == nullptr ? std::string_view::npos : find_control(text->get());
    if (at == std::string_view::npos) return;
    const toml::source_position begin = node.source().begin;
    throw IoError(fmt::format("{}:{}:{}", file, begin.line, begin.column),
                  fmt::format("a text with the control character {} at byte {}; tab and line end are allowed",
                              control_shown(text->get(), at), at + 1));
}

constexpr std::size_t kMostKept = 100;
constexpr std::size_t kLongestPath = 200;  // characters of a key that a message repeats

/// What stands before and behind a place of the text, on its line.
struct Place {
    std::string_view before, behind;
};

Place text_at(std::string_view bytes, const toml::source_position& at) {
    for (toml::source_index line = 1; line < at.line && bytes.find('\n') < bytes.size(); ++line) bytes.remove_prefix(bytes.find('\n') + 1);
    bytes = bytes.substr(0, bytes.find('\n'));
    const std::size_t column = std::min<std::size_t>(at.column - 1, bytes.size());
    return {bytes.substr(0, column), bytes.substr(column)};
}

/// What to write instead, for mistakes of people who write TOML for the first time; "": not known.
std::string remedy(const Place& place, std::string_view description) {
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    const bool value = place.before.find('=') != std::string_view::npos;
    const std::size_t last = place.before.find_last_not_of(" \t");
    const bool behind_number = value && last != std::string_view::npos && (is_digit(place.before[last]) || place.before[last] == '.');
    if (behind_number && place.behind.starts_with(',')) return "; a number has a decimal point: 0.8";
    if (behind_number && !place.behind.empty() && std::isalpha(static_cast<unsigned char>(place.behind.front())) != 0)
        return "; a unit stands in the name of its key, not behind the number";
    if (!value && place.behind.starts_with(':')) return "; write KEY = VALUE";
    if (description.ends_with("could not determine value type")) return "; a text stands in quotation marks";
    if (description.find("unescaped control characters") != std::string_view::npos) return "; a text ends with a quotation mark";
    return "";
}

}  // namespace

toml::table parse_toml(std::string_view bytes, const std::string& file) {
    Scanner(bytes, file).check();
    try {
        toml::table table = toml::parse(bytes);
        require_plain_texts(table, file);
        return table;
    } catch (const toml::parse_error& e) {
        const toml::source_position at = e.source().begin;
        throw IoError(fmt::format("{}:{}:{}", file, at.line, at.column),
                      fmt::format("not valid TOML: {}{}", e.description(), remedy(text_at(bytes, at), e.description())));
    }
}

std::string shown(const toml::node& node) {
    constexpr std::size_t kLongest = 80;
    if (const auto* number = node.as_floating_point(); number && std::isfinite(number->get())) {
        const std::string shortest = fmt::format("{}", number->get());  // toml++ shows 17 digits: 0.49 as 0.48999999999999999
        return shortest.find_first_of(".e") == std::string::npos ? shortest + ".0" : shortest;
    }
    std::ostringstream text;
    node.visit([&text](const auto& typed) { text << typed; });
    return printable(text.str(), kLongest);
}

std::string toml_place(const std::string& file, const toml::source_region& at, std::string_view path) {
    return fmt::format("{}:{}:{}: {}", file, at.begin.line, at.begin.column, printable(path, kLongestPath));
}

void TomlFaults::add(const toml::source_region& at, std::string_view path, std::string value, std::string allowed) {
    ++count_;
    if (full())
        ++left_out_;
    else
        here_.push_back({at.begin, InvalidInput(toml_place(file_, at, path), std::move(value), std::move(allowed))});
}

bool TomlFaults::full() const { return here_.size() >= kMostKept; }

void TomlFaults::throw_if_any() {
    const auto position = [](const Fault& fault) { return std::pair(fault.at.line, fault.at.column); };
    std::stable_sort(here_.begin(), here_.end(), [&](const Fault& a, const Fault& b) { return position(a) < position(b); });
    Mistakes all;
    for (Fault& fault : here_) all.add(std::move(fault.mistake));
    if (left_out_ > 0) all.add(InvalidInput(file_, fmt::format("{} more mistakes", left_out_), "none"));
    all.collect([this] { elsewhere_.throw_if_any(); });
    all.throw_if_any();
}

}  // namespace fusee::core
