#pragma once
#include <array>
#include <cstddef>
#include <list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fusee/core/error.h"

/// Bytes of a table as text, lines as cells, cells as numbers.
namespace fusee::core {

/// UTF-8 from UTF-8, UTF-16 (with a mark, or where every second byte is 0) or Windows-1252, in pieces cut anywhere. The first piece
/// decides.
class TextDecoder {
public:
    /// @returns text that lives until the next call
    [[nodiscard]] std::string_view utf8(std::string_view bytes);

private:
    enum class Encoding { kUnknown, kUtf8, kLittle, kBig, kWindows };
    void decide(std::string_view& bytes);
    void take_pairs(std::string_view bytes);
    void append(char32_t code);

    Encoding encoding_ = Encoding::kUnknown;
    std::string text_, odd_;
    char32_t lead_ = 0;  // the first half of a surrogate pair
};

/// Between two cells.
enum class Separator : char {
    kComma = ',',
    kSemicolon = ';',
    kTab = '\t',
    kBar = '|',
    kWide = 'w',   ///< two blanks or more, or a tab
    kBlanks = ' '  ///< blanks or tabs
};
[[nodiscard]] const char* name_of(Separator separator);

struct CsvCell {
    std::string_view text;
    std::size_t place;  ///< of its first character, from 1
};

/// Cells of one line; a cell in double quotes may hold separators, line ends and doubled quotes (RFC 4180).
class CellSplitter {
public:
    /// @returns false where a quote does not close: the line goes on in the next one
    [[nodiscard]] bool split(std::string_view line, Separator separator, std::vector<CsvCell>& cells);

private:
    std::list<std::string> unquoted_;  // of cells with doubled quotes, for the last line
};

/// What one number shows of the decimal mark.
enum class MarkEvidence { kNone, kPoint, kComma, kEitherPoint, kEitherComma };
/// "0,5": a comma. "1.234,5": a comma. "1,234": either, a thousand or a decimal.
[[nodiscard]] MarkEvidence mark_evidence(std::string_view number);
/// A finite number with that decimal mark; the other mark, blanks and apostrophes may stand between groups of three figures.
[[nodiscard]] std::optional<double> parse_number(std::string_view text, char decimal);

/// A cell in quotes for a message, cut at 60 characters.
[[nodiscard]] std::string in_quotes(std::string_view text);
/// "file:line:place: what"
[[nodiscard]] InvalidInput fault_at(const std::string& file, std::size_t line, std::size_t place, std::string_view what, std::string value,
                                    std::string allowed);

/// A blank line, one of separators alone, or a comment: '#', '%' or "//", in quotes too.
[[nodiscard]] bool says_nothing(std::string_view line);
/// The line without its comment sign: a header may stand behind it. Empty: no comment.
[[nodiscard]] std::string_view behind_comment_sign(std::string_view line);

/// The decimal mark of a table, from the numbers of its first lines.
class DecimalMark {
public:
    /// One number of a column, and where it stands.
    void add(std::size_t column, std::string_view number, std::size_t line, std::size_t place);

    struct Verdict {
        char decimal = '.';
        std::string value;   ///< of a fault; "": none
        bool mixed = false;  ///< both marks are used; else the number `value` reads both ways
        std::size_t line = 0, place = 0, column = 0;
    };
    /// @param lone a number with one point before three figures is a decimal where nothing tells
    [[nodiscard]] Verdict verdict(bool lone) const;

private:
    struct Seen {
        std::string text;
        std::size_t line = 0, place = 0, column = 0;
    };
    using Marks = std::array<Seen, 5>;  // by MarkEvidence: the first number that shows it
    [[nodiscard]] const Seen* first(MarkEvidence mark) const;
    static const Seen& at(const Marks& marks, MarkEvidence mark) { return marks[static_cast<std::size_t>(mark)]; }
    static Verdict question(const Seen& seen);

    std::map<std::size_t, Marks> seen_;  // by column
};

}  // namespace fusee::core
