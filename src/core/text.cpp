#include "fusee/core/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <sstream>
#include <utility>

#include "fusee/core/error.h"

namespace fusee::core {

namespace {

constexpr char32_t kMostUnicode = 0x10FFFF;

bool is_control(char32_t code) { return code < 0x20 || (code >= 0x7F && code < 0xA0); }

/// Characters that are not seen but change what is: marks of writing direction, joiners and blanks without width, separators of lines and
/// paragraphs, tags. (Unicode's Default_Ignorable_Code_Point but for the variation selectors, which belong to letters.)
bool is_mark(char32_t code) {
    constexpr std::array<std::pair<char32_t, char32_t>, 12> kMarks{{{0xAD, 0xAD},
                                                                    {0x34F, 0x34F},
                                                                    {0x61C, 0x61C},
                                                                    {0x115F, 0x1160},
                                                                    {0x17B4, 0x17B5},
                                                                    {0x180E, 0x180E},
                                                                    {0x200B, 0x200F},
                                                                    {0x2028, 0x202E},
                                                                    {0x2060, 0x206F},
                                                                    {0xFEFF, 0xFEFF},
                                                                    {0xFFF0, 0xFFFB},
                                                                    {0xE0000, 0xE0FFF}}};
    return std::any_of(kMarks.begin(), kMarks.end(), [code](const auto& range) { return code >= range.first && code <= range.second; });
}

std::string visible(const Character& c, std::string_view bytes, bool tabs) {
    if (!c.valid) return fmt::format("\\x{:02x}", static_cast<unsigned>(c.code));
    if (c.code == '\n') return "\\n";
    if (c.code == '\t') return tabs ? "\t" : "\\t";
    if (is_control(c.code)) return fmt::format("\\x{:02x}", static_cast<unsigned>(c.code));
    if (is_mark(c.code)) return fmt::format("\\u{:04x}", static_cast<unsigned>(c.code));
    return std::string(bytes.substr(0, c.bytes));
}

std::string all_visible(std::string_view text, std::size_t most, bool tabs) {
    std::string out;
    std::size_t count = 0;
    for (std::size_t at = 0; at < text.size(); ++count) {
        const Character c = first_character(text.substr(at));
        if (count < most) out += visible(c, text.substr(at), tabs);
        at += c.bytes;
    }
    return count > most ? fmt::format("{}... ({} characters)", out, count) : out;
}

}  // namespace

std::string printable(std::string_view text, std::size_t most) { return all_visible(text, most, false); }

std::string printable_lines(std::string_view text, std::size_t most) {
    std::string lines;
    while (true) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines += all_visible(text.substr(0, end), most, true);
        if (end == text.size()) return lines;
        lines += '\n';
        text.remove_prefix(end + 1);
    }
}

void require_plain_name(const std::filesystem::path& path) {
    const std::string name = path.filename().string();
    for (std::size_t at = 0; at < name.size();) {
        const Character c = first_character(std::string_view(name).substr(at));
        if (c.valid && (is_control(c.code) || is_mark(c.code)) && c.code != '\n' && c.code != '\t')
            throw IoError(path.string(),
                          "no file is written under a name with characters that are not seen; rename the file that it is from");
        at += c.bytes;
    }
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
    constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./,:+@%";
    if (!text.empty() && text.find_first_not_of(kPlain) == std::string_view::npos) return std::string(text);
    std::string word = "'";
    for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return word + "'";
}

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

std::vector<std::string> words_of(std::string_view text) {
    std::istringstream in{std::string(text)};
    return {std::istream_iterator<std::string>(in), {}};
}

std::string lower(std::string_view text) {
    std::string out(text);
    for (char& c : out)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return out;
}

std::size_t letters(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

}  // namespace fusee::core
