#include "csv_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "fusee/core/text.h"

namespace fusee::core {

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string_view without_blanks(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

/// The separator that begins at `at`: its bytes, 0 for none.
std::size_t separator_at(std::string_view line, std::size_t at, Separator separator) {
    if (separator != Separator::kWide && separator != Separator::kBlanks) return line[at] == static_cast<char>(separator) ? 1 : 0;
    std::size_t end = at;
    bool tab = false;
    while (end < line.size() && is_blank(line[end])) tab |= line[end++] == '\t';
    return separator == Separator::kBlanks || tab || end - at >= 2 ? end - at : 0;
}

/// Figures before a decimal mark without their groups; empty where these are no groups of three.
std::string ungrouped(std::string_view text, char decimal) {
    constexpr std::array<std::string_view, 6> kMarks{" ", "\xC2\xA0", "\xE2\x80\xAF", "\xE2\x80\x89", "'", "\xE2\x80\x99"};
    const std::string other(1, decimal == ',' ? '.' : ',');
    std::string figures, mark;
    std::size_t group = 0;
    for (std::size_t at = 0; at < text.size();) {
        if (is_digit(text[at])) {
            figures += text[at++];
            ++group;
            continue;
        }
        std::string found = text.substr(at).starts_with(other) ? other : "";
        for (const std::string_view each : kMarks)
            if (found.empty() && text.substr(at).starts_with(each)) found = each;
        if (found.empty() || (!mark.empty() && found != mark) || (mark.empty() ? group < 1 || group > 3 : group != 3)) return {};
        mark = found;
        group = 0;
        at += found.size();
    }
    return mark.empty() || group == 3 ? figures : std::string();
}

}  // namespace

std::string_view TextDecoder::utf8(std::string_view bytes) {
    if (encoding_ == Encoding::kUnknown) decide(bytes);
    if (encoding_ == Encoding::kUtf8 || encoding_ == Encoding::kUnknown) return bytes;
    text_.clear();
    if (encoding_ == Encoding::kWindows)
        for (const char c : bytes) append(static_cast<unsigned char>(c));
    else
        take_pairs(bytes);
    return text_;
}

void TextDecoder::decide(std::string_view& bytes) {
    if (bytes.empty()) return;
    const auto zeros = [bytes](std::size_t from) {
        std::size_t count = 0;
        for (std::size_t i = from; i < std::min<std::size_t>(bytes.size(), 64); i += 2) count += bytes[i] == '\0' ? 1 : 0;
        return bytes.size() >= 4 && 8 * count > 3 * std::min<std::size_t>(bytes.size(), 64);
    };
    if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) {
        encoding_ = bytes.front() == '\xFF' ? Encoding::kLittle : Encoding::kBig;
        bytes.remove_prefix(2);
    } else if (zeros(1) || zeros(0)) {
        encoding_ = zeros(1) ? Encoding::kLittle : Encoding::kBig;
    } else {
        // Windows-1252 where a byte alone spells a unit, as an old spreadsheet does: degrees, micro, a dot, a square.
        constexpr std::string_view kUnitBytes = "\xB0\xB5\xB7\xB2";
        encoding_ = Encoding::kUtf8;
        const std::size_t cut = bytes.size() > 1000 ? 3 : 0;  // the piece may end inside of a character
        for (std::size_t i = 0; i + cut < bytes.size(); ++i) {
            const auto byte = static_cast<unsigned char>(bytes[i]);
            const bool follows = i > 0 && static_cast<unsigned char>(bytes[i - 1]) >= 0x80;
            const bool leads = byte >= 0xC0 && i + 1 < bytes.size() && (static_cast<unsigned char>(bytes[i + 1]) & 0xC0U) == 0x80;
            if (byte >= 0x80 && !follows && !leads && (byte >= 0xC0 || kUnitBytes.find(bytes[i]) != std::string_view::npos))
                encoding_ = Encoding::kWindows;
        }
    }
    if (bytes.starts_with(kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());
}

void TextDecoder::take_pairs(std::string_view bytes) {
    const std::string all = odd_ + std::string(bytes);
    odd_ = all.size() % 2 == 1 ? all.substr(all.size() - 1) : "";
    for (std::size_t i = 0; i + 1 < all.size(); i += 2) {
        const auto low = static_cast<unsigned char>(all[encoding_ == Encoding::kLittle ? i : i + 1]);
        const auto high = static_cast<unsigned char>(all[encoding_ == Encoding::kLittle ? i + 1 : i]);
        const char32_t unit = static_cast<char32_t>(high) << 8U | low;
        if (unit >= 0xD800 && unit < 0xDC00) {
            lead_ = unit;
        } else if (unit >= 0xDC00 && unit < 0xE000) {
            append(lead_ == 0 ? 0xFFFD : 0x10000 + ((lead_ - 0xD800) << 10U) + (unit - 0xDC00));
            lead_ = 0;
        } else if (unit != 0xFEFF) {
            append(unit);
        }
    }
}

void TextDecoder::append(char32_t code) {
    const auto six = [code](unsigned shift) { return static_cast<char>(0x80U | ((code >> shift) & 0x3FU)); };
    if (code < 0x80) {
        text_ += static_cast<char>(code);
    } else if (code < 0x800) {
        text_ += {static_cast<char>(0xC0U | (code >> 6U)), six(0)};
    } else if (code < 0x10000) {
        text_ += {static_cast<char>(0xE0U | (code >> 12U)), six(6), six(0)};
    } else {
        text_ += {static_cast<char>(0xF0U | (code >> 18U)), six(12), six(6), six(0)};
    }
}

const char* name_of(Separator separator) {
    switch (separator) {
        case Separator::kComma:
            return "commas";
        case Separator::kSemicolon:
            return "semicolons";
        case Separator::kTab:
            return "tabs";
        case Separator::kBar:
            return "bars";
        case Separator::kWide:
        case Separator::kBlanks:
            break;
    }
    return "blanks";
}

bool CellSplitter::split(std::string_view line, Separator separator, std::vector<CsvCell>& cells) {
    cells.clear();
    unquoted_.clear();
    const bool blanks = separator == Separator::kBlanks || separator == Separator::kWide;
    if (blanks)
        while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
    std::size_t at = 0;
    while (true) {
        while (at < line.size() && is_blank(line[at]) && (blanks || separator_at(line, at, separator) == 0)) ++at;
        const std::size_t begin = at;
        if (at < line.size() && line[at] == '"') {
            std::string text;
            bool doubled = false;
            for (++at; at < line.size() && (line[at] != '"' || (at + 1 < line.size() && line[at + 1] == '"')); ++at) {
                doubled |= line[at] == '"';
                text += line[at];
                if (line[at] == '"') ++at;
            }
            if (at >= line.size()) return false;
            const std::string_view inside = doubled ? unquoted_.emplace_back(std::move(text)) : line.substr(begin + 1, at - begin - 1);
            ++at;
            std::size_t rest = at;
            while (rest < line.size() && separator_at(line, rest, separator) == 0) ++rest;
            // Behind the closing quote stands the separator; else the quotes are part of the text.
            const bool whole = without_blanks(line.substr(at, rest - at)).empty();
            cells.push_back({whole ? without_blanks(inside) : without_blanks(line.substr(begin, rest - begin)), begin + 1});
            at = rest;
        } else {
            while (at < line.size() && separator_at(line, at, separator) == 0) ++at;
            cells.push_back({without_blanks(line.substr(begin, at - begin)), begin + 1});
        }
        if (at >= line.size()) return true;
        at += separator_at(line, at, separator);
    }
}

MarkEvidence mark_evidence(std::string_view number) {
    number = without_blanks(number);
    if (!number.empty() && (number.front() == '+' || number.front() == '-')) number.remove_prefix(1);
    const auto count = [number](char c) { return std::count(number.begin(), number.end(), c); };
    const auto points = count('.'), commas = count(',');
    if (points + commas == 0 || number.find_first_not_of("0123456789.,eE+-") != std::string_view::npos) return MarkEvidence::kNone;
    if (points > 0 && commas > 0) return number.rfind('.') > number.rfind(',') ? MarkEvidence::kPoint : MarkEvidence::kComma;
    if (points + commas > 1) return points > 0 ? MarkEvidence::kComma : MarkEvidence::kPoint;
    const std::size_t mark = number.find_first_of(".,");
    const bool either = mark >= 1 && mark <= 3 && number.front() != '0' && number.size() == mark + 4;
    if (points > 0) return either ? MarkEvidence::kEitherPoint : MarkEvidence::kPoint;
    return either ? MarkEvidence::kEitherComma : MarkEvidence::kComma;
}

std::optional<double> parse_number(std::string_view text, char decimal) {
    constexpr std::string_view kMinus = "\xE2\x88\x92";
    double value = 0.0;
    const auto read = [&value](std::string_view digits) {
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        return error == std::errc() && end == digits.data() + digits.size() && std::isfinite(value);
    };
    if (decimal == '.' && read(text)) return value;
    std::string plain;
    if (text.starts_with(kMinus)) {
        plain = "-";
        text.remove_prefix(kMinus.size());
    } else if (!text.empty() && (text.front() == '-' || text.front() == '+')) {
        if (text.front() == '-') plain = "-";
        text.remove_prefix(1);
    }
    if (text.empty() || text.front() == '-' || text.front() == '+') return {};
    const std::size_t mark = std::min({text.find(decimal), text.find_first_of("eE"), text.size()});
    const std::string_view whole = text.substr(0, mark);
    const bool bare = std::all_of(whole.begin(), whole.end(), is_digit);
    const std::string figures = bare ? std::string(whole) : ungrouped(whole, decimal);
    if (!bare && figures.empty()) return {};
    plain += figures;
    if (mark < text.size()) plain += std::string(text.substr(mark));
    if (decimal == ',') {
        if (plain.find('.') != std::string::npos) return {};
        std::replace(plain.begin(), plain.end(), ',', '.');
    }
    return read(plain) ? std::optional(value) : std::nullopt;
}

std::string in_quotes(std::string_view text) {
    constexpr std::size_t kShown = 60;
    return fmt::format("'{}'", printable(text, kShown));
}

InvalidInput fault_at(const std::string& file, std::size_t line, std::size_t place, std::string_view what, std::string value,
                      std::string allowed) {
    return {fmt::format("{}:{}:{}: {}", file, line, place, what), std::move(value), std::move(allowed)};
}

bool says_nothing(std::string_view line) {
    return line.find_first_not_of(" \t,;|\"") == std::string_view::npos || !behind_comment_sign(line).empty() || line.starts_with('#') ||
           line.starts_with('%') || line.starts_with("//") || line.starts_with("\"#");
}

std::string_view behind_comment_sign(std::string_view line) {
    std::size_t signs = 0;
    if (line.starts_with('"')) line.remove_prefix(1);
    while (signs < line.size() && (line[signs] == '#' || line[signs] == '%')) ++signs;
    if (signs == 0 && line.starts_with("//")) signs = 2;
    return signs == 0 ? std::string_view() : line.substr(signs);
}

void DecimalMark::add(std::size_t column, std::string_view number, std::size_t line, std::size_t place) {
    const MarkEvidence mark = mark_evidence(number);
    if (mark == MarkEvidence::kNone) return;
    Seen& seen = seen_[column][static_cast<std::size_t>(mark)];
    if (seen.line == 0) seen = {std::string(number), line, place, column};
}

DecimalMark::Verdict DecimalMark::verdict(bool lone) const {
    const Seen* comma = first(MarkEvidence::kComma);
    const Seen* point = first(MarkEvidence::kPoint);
    if (comma != nullptr && point != nullptr)
        return {'.',
                fmt::format("{} has a decimal comma, {} in line {} a decimal point", in_quotes(comma->text), in_quotes(point->text),
                            point->line),
                true,
                comma->line,
                comma->place,
                comma->column};
    // Where the file's mark is known, a number with the other mark alone is asked about unless its own column shows the mark as well.
    const MarkEvidence sure = comma != nullptr ? MarkEvidence::kComma : MarkEvidence::kPoint;
    const MarkEvidence either = comma != nullptr ? MarkEvidence::kEitherPoint : MarkEvidence::kEitherComma;
    for (const auto& [column, marks] : seen_) {
        if (at(marks, either).line != 0 && at(marks, sure).line == 0) return question(at(marks, either));
        if (comma == nullptr && point == nullptr && !lone && at(marks, MarkEvidence::kEitherPoint).line != 0)
            return question(at(marks, MarkEvidence::kEitherPoint));
    }
    return {comma != nullptr ? ',' : '.', "", false, 0, 0, 0};
}

const DecimalMark::Seen* DecimalMark::first(MarkEvidence mark) const {
    const Seen* found = nullptr;
    for (const auto& [column, marks] : seen_)
        if (at(marks, mark).line != 0 && (found == nullptr || at(marks, mark).line < found->line)) found = &at(marks, mark);
    return found;
}

DecimalMark::Verdict DecimalMark::question(const Seen& seen) {
    std::string decimal = seen.text, thousand = seen.text;
    const bool comma = decimal.find(',') != std::string::npos;
    std::replace(decimal.begin(), decimal.end(), ',', '.');
    std::erase_if(thousand, [](char c) { return c == ',' || c == '.'; });
    return {'.',
            fmt::format("{} is {} with a decimal {}, or {} with groups of three figures", in_quotes(seen.text), decimal,
                        comma ? "comma" : "point", thousand),
            false,
            seen.line,
            seen.place,
            seen.column};
}

}  // namespace fusee::core
