#include "csv_decimal.h"

#include <fmt/format.h>

#include <algorithm>

namespace fusee::core {

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
