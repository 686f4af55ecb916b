#include "fusee/core/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace fusee::core {

namespace {

/// One character of a text: a code point of UTF-8, or an invalid byte.
struct Character {
    std::size_t bytes = 1;
    char32_t code = 0;
    bool valid = true;
};

constexpr char32_t kMostUnicode = 0x10FFFF;

/// @pre !text.empty()
Character first_character(std::string_view text) {
    const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    if (byte(0) < 0x80) return {1, byte(0), true};
    const std::size_t length = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : 2;
    constexpr std::array<char32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};  // longer encodings of shorter codes are invalid
    const Character broken{1, byte(0), false};
    if (byte(0) < 0xC0 || byte(0) >= 0xF8 || length > text.size()) return broken;
    char32_t code = byte(0) & (0xFFU >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0U) != 0x80) return broken;
        code = (code << 6U) | (byte(i) & 0x3FU);
    }
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    return code < kLeast[length] || code > kMostUnicode || surrogate ? broken : Character{length, code, true};
}

bool is_control(char32_t code) { return code < 0x20 || (code >= 0x7F && code < 0xA0); }

/// Line and paragraph separators, and marks of writing direction.
bool is_mark(char32_t code) {
    return code == 0x200E || code == 0x200F || (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
}

std::string visible(const Character& c, std::string_view bytes) {
    if (!c.valid) return fmt::format("\\x{:02x}", static_cast<unsigned>(c.code));
    if (c.code == '\n') return "\\n";
    if (c.code == '\t') return "\\t";
    if (is_control(c.code)) return fmt::format("\\x{:02x}", static_cast<unsigned>(c.code));
    if (is_mark(c.code)) return fmt::format("\\u{:04x}", static_cast<unsigned>(c.code));
    return std::string(bytes.substr(0, c.bytes));
}

}  // namespace

std::string printable(std::string_view text, std::size_t most) {
    std::string out;
    std::size_t count = 0;
    for (std::size_t at = 0; at < text.size(); ++count) {
        const Character c = first_character(text.substr(at));
        if (count < most) out += visible(c, text.substr(at));
        at += c.bytes;
    }
    return count > most ? fmt::format("{}... ({} characters)", out, count) : out;
}

std::size_t find_control(std::string_view text) {
    for (std::size_t at = 0; at < text.size();) {
        const Character c = first_character(text.substr(at));
        const bool allowed = c.code == '\t' || c.code == '\n' || c.code == '\r';
        if (!c.valid || (is_control(c.code) && !allowed)) return at;
        at += c.bytes;
    }
    return std::string_view::npos;
}

std::string counted(std::size_t n, std::string_view what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); }

std::string bytes_text(double bytes) {
    if (bytes < 1e3) return fmt::format("{:.0f} B", bytes);
    if (bytes < 1e6) return fmt::format("{:.1f} kB", bytes / 1e3);
    return bytes < 1e9 ? fmt::format("{:.2f} MB", bytes / 1e6) : fmt::format("{:.2f} GB", bytes / 1e9);
}

std::string shell_word(std::string_view text) {
    std::string word = "'";
    for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return word + "'";
}

std::size_t letters(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

}  // namespace fusee::core
