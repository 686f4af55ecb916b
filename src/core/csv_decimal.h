#pragma once
#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "csv_text.h"

namespace fusee::core {

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
