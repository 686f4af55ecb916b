#include "step_scan.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <vector>

#include "fusee/core/error.h"

namespace fusee::exchange {

namespace {

constexpr std::string_view kBegin = "ISO-10303-21", kEnd = "END-ISO-10303-21";
constexpr std::size_t kHeader = 1000;  // bytes that must contain kBegin
constexpr int kDeepestNesting = 100;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_'; }

/// The number of an entity and its line.
struct Entity {
    std::uint64_t number = 0;
    std::size_t line = 0;
};
bool operator<(const Entity& a, const Entity& b) { return a.number != b.number ? a.number < b.number : a.line < b.line; }

class StepScan {
public:
    StepScan(std::string_view bytes, const std::filesystem::path& path) : bytes_(bytes), path_(path) {}

    void run() {
        while (at_ < bytes_.size()) token();
        if (depth_ != 0) fail("a parenthesis is not closed");
        std::sort(defined_.begin(), defined_.end());
        const auto same = [](const Entity& a, const Entity& b) { return a.number == b.number; };
        if (const auto twice = std::adjacent_find(defined_.begin(), defined_.end(), same); twice != defined_.end())
            fail_at((twice + 1)->line, fmt::format("#{} is defined twice", twice->number));
        for (const Entity& e : referenced_) {
            const auto found = std::lower_bound(defined_.begin(), defined_.end(), Entity{e.number, 0});
            if (found == defined_.end() || found->number != e.number)
                fail_at(e.line, fmt::format("#{} is referenced but not defined", e.number));
        }
    }

private:
    [[noreturn]] void fail_at(std::size_t line, const std::string& why) const {
        throw core::IoError(path_.string(), fmt::format("line {}: {}", line, why));
    }
    [[noreturn]] void fail(const std::string& why) const { fail_at(line_, why); }

    [[nodiscard]] char peek(std::size_t ahead = 0) const { return at_ + ahead < bytes_.size() ? bytes_[at_ + ahead] : '\0'; }

    void token() {
        const char c = peek();
        if (c == '\'' || c == '"') return skip_to(c, 1, "a text is not closed");
        if (c == '/' && peek(1) == '*') return skip_comment();
        if (c == '#') return entity();
        if (depth_ > 0 && (is_digit(c) || c == '+' || c == '-' || c == '.')) return value();
        if (depth_ > 0 && is_letter(c)) return word();
        if (c == '(' && ++depth_ > kDeepestNesting) fail(fmt::format("parentheses are nested more than {} deep", kDeepestNesting));
        if (c == ')' && --depth_ < 0) fail("a closing parenthesis has no opening one");
        if (c == ';' && depth_ != 0) fail("a parenthesis is not closed");
        advance(1);
    }

    void advance(std::size_t count) {
        const std::string_view passed = bytes_.substr(at_, count);
        line_ += static_cast<std::size_t>(std::count(passed.begin(), passed.end(), '\n'));
        at_ += passed.size();
    }
    /// Moves behind the next `mark` at or after `from`.
    void skip_to(char mark, std::size_t from, const char* why) {
        const std::size_t end = bytes_.find(mark, at_ + from);
        if (end == std::string_view::npos) fail(why);
        advance(end + 1 - at_);
    }
    void skip_comment() {
        const std::size_t end = bytes_.find("*/", at_ + 2);
        if (end == std::string_view::npos) fail("a comment is not closed");
        advance(end + 2 - at_);
    }

    /// #N: a definition if "=" follows, else a reference.
    void entity() {
        Entity entity{0, line_};
        const char* const first = bytes_.data() + at_ + 1;
        const auto [end, error] = std::from_chars(first, bytes_.data() + bytes_.size(), entity.number);
        if (error != std::errc()) fail("# is not followed by the number of an entity");
        advance(static_cast<std::size_t>(end - first) + 1);
        while (peek() == ' ' || peek() == '\t' || peek() == '\r' || peek() == '\n') advance(1);
        (depth_ == 0 && peek() == '=' ? defined_ : referenced_).push_back(entity);
    }

    /// A number, or an enumeration between dots.
    void value() {
        if (peek() == '.' && is_letter(peek(1))) return skip_to('.', 1, "an enumeration is not closed");
        const std::size_t begin = peek() == '+' ? at_ + 1 : at_;  // from_chars accepts no +
        std::size_t end = begin;
        while (end < bytes_.size() &&
               (is_digit(bytes_[end]) || is_letter(bytes_[end]) || bytes_[end] == '.' || bytes_[end] == '+' || bytes_[end] == '-'))
            ++end;
        double number = 0.0;
        const auto [stop, error] = std::from_chars(bytes_.data() + begin, bytes_.data() + end, number);
        const bool small =
            error == std::errc::result_out_of_range && bytes_.substr(begin, end - begin).find("E-") != std::string_view::npos;
        if (!small && (error != std::errc() || stop != bytes_.data() + end || !std::isfinite(number)))
            fail(fmt::format("{} is not a finite number", shown(begin, end)));
        advance(end - at_);
    }
    /// A typed value: LENGTH_MEASURE(1.0). @throws IoError for nan and any other word without a value
    void word() {
        std::size_t end = at_;
        while (end < bytes_.size() && (is_letter(bytes_[end]) || is_digit(bytes_[end]))) ++end;
        const std::size_t next = std::min(bytes_.find_first_not_of(" \t\r\n", end), bytes_.size());
        if (next == bytes_.size() || bytes_[next] != '(') fail(fmt::format("{} is not a value", shown(at_, end)));
        advance(end - at_);
    }
    /// Quotes at most 40 characters of the file: letters, digits and signs.
    [[nodiscard]] std::string shown(std::size_t begin, std::size_t end) const {
        return fmt::format("'{}'", bytes_.substr(begin, std::min<std::size_t>(end - begin, 40)));
    }

    std::string_view bytes_;
    const std::filesystem::path& path_;
    std::size_t at_ = 0, line_ = 1;
    int depth_ = 0;
    std::vector<Entity> defined_, referenced_;
};

}  // namespace

void require_sound_step(std::string_view bytes, const std::filesystem::path& path) {
    if (bytes.substr(0, kHeader).find(kBegin) == std::string_view::npos)
        throw core::IoError(path.string(), fmt::format("is not a STEP file: {} is missing", kBegin));
    const std::size_t end = bytes.rfind(kEnd);
    if (end == std::string_view::npos) throw core::IoError(path.string(), fmt::format("is a STEP file without an end ({})", kEnd));
    StepScan(bytes.substr(0, end), path).run();
}

}  // namespace fusee::exchange
