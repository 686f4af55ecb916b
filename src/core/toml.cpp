#include "fusee/core/toml.h"

#include <fmt/format.h>

#include <cmath>
#include <sstream>

#include "fusee/core/error.h"

namespace fusee::core {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// Walks over comments and strings as wholes; everything else is syntax.
class Scanner {
public:
    explicit Scanner(std::string_view text) : text_(text) {
        if (text_.starts_with(kByteOrderMark)) at_ = line_start_ = kByteOrderMark.size();
    }

    /// To the next character of syntax that is not ASCII; false at the end.
    bool find_foreign() {
        while (at_ < text_.size()) {
            if (static_cast<unsigned char>(text_[at_]) >= 0x80) return true;
            if (text_[at_] == '#')
                skip_comment();
            else if (text_[at_] == '"' || text_[at_] == '\'')
                skip_string(text_[at_]);
            else
                step();
        }
        return false;
    }
    [[nodiscard]] std::size_t line() const { return line_; }
    [[nodiscard]] std::size_t column() const { return at_ - line_start_ + 1; }

private:
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
            if (text_[at_] == '\n' && !many_lines) return;  // an unclosed string: the parser says so
            if (quote == '"' && text_[at_] == '\\' && at_ + 1 < text_.size()) step();
            step();
        }
        for (std::size_t i = 0; i < end.size() && at_ < text_.size(); ++i) step();
    }

    std::string_view text_;
    std::size_t at_ = 0, line_ = 1, line_start_ = 0;
};

void require_ascii_syntax(std::string_view toml, const std::string& file) {
    Scanner scanner(toml);
    if (scanner.find_foreign())
        throw IoError(fmt::format("{}:{}:{}", file, scanner.line(), scanner.column()),
                      "a character outside ASCII; such characters may stand in comments and quoted texts only");
}

}  // namespace

toml::table parse_toml(std::string_view bytes, const std::string& file) {
    require_ascii_syntax(bytes, file);
    try {
        return toml::parse(bytes);
    } catch (const toml::parse_error& e) {
        const toml::source_position at = e.source().begin;
        throw IoError(fmt::format("{}:{}:{}", file, at.line, at.column), fmt::format("no valid TOML: {}", e.description()));
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
    return text.str().substr(0, kLongest);
}

}  // namespace fusee::core
