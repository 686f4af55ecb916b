#include "fusee/core/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
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

constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

constexpr std::size_t kLongestCompared = 100;  // letters: known names have less than half as many

std::string small(std::string_view text) { return lower(text.substr(0, kLongestCompared)); }

struct Near {
    std::size_t distance;
    const std::string* name;
};

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

std::string base64(std::string_view bytes) {
    std::string text;
    std::uint32_t held = 0;
    int bits = 0;
    for (const char byte : bytes) {
        held = held << 8 | static_cast<unsigned char>(byte);
        for (bits += 8; bits >= 6; bits -= 6) text += kDigits[held >> (bits - 6) & 63];
    }
    if (bits > 0) text += kDigits[held << (6 - bits) & 63];
    while (text.size() % 4 != 0) text += '=';
    return text;
}

std::string from_base64(std::string_view text) {
    std::string bytes;
    std::uint32_t held = 0;
    int bits = 0;
    for (const char digit : text) {
        const std::size_t value = kDigits.find(digit);
        if (value == std::string_view::npos) continue;  // line ends
        held = held << 6 | static_cast<std::uint32_t>(value);
        bits += 6;
        if (bits < 8) continue;
        bits -= 8;
        bytes += static_cast<char>(held >> bits & 255);
    }
    return bytes;
}

std::string escape(std::string_view text) {
    std::string out;
    for (const char c : printable_lines(text)) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            case '\'':
                out += "&#39;";
                break;
            default:
                out += c;
        }
    }
    return out;
}

std::string coordinate(double value) {
    std::string text = fmt::format("{:.3f}", value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text.pop_back();
    return text == "-0" ? "0" : text;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
    for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i)
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replaced});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
    return d.back().back();
}

std::vector<std::string> near_names(std::string_view asked, const std::vector<std::string>& names, std::size_t most) {
    constexpr std::size_t kLeastBeginning = 3;  // letters that identify a name
    const std::string wanted = small(asked);
    std::vector<Near> near;
    for (const std::string& name : names) {
        const std::string known = small(name);
        const bool begins = wanted.size() >= kLeastBeginning && known.starts_with(wanted);
        const std::size_t distance = begins ? 1 : edit_distance(wanted, known);
        if (distance <= std::max<std::size_t>(1, known.size() / 3) && distance < wanted.size()) near.push_back({distance, &name});
    }
    std::stable_sort(near.begin(), near.end(), [](const Near& a, const Near& b) { return a.distance < b.distance; });
    std::vector<std::string> found;
    for (const Near& one : near)
        if (found.size() < most && std::find(found.begin(), found.end(), *one.name) == found.end()) found.push_back(*one.name);
    return found;
}

std::string did_you_mean(std::string_view asked, const std::vector<std::string>& names, std::string_view quote) {
    const std::vector<std::string> near = near_names(asked, names);
    if (near.empty()) return "";
    std::string text;
    for (std::size_t i = 0; i < near.size(); ++i)
        text += fmt::format("{}{}{}{}", i == 0 ? "" : i + 1 == near.size() ? " or " : ", ", quote, near[i], quote);
    return "; did you mean " + text + "?";
}

}  // namespace fusee::core
