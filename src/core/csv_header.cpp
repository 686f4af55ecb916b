#include "csv_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "fusee/core/lists.h"
#include "fusee/core/text.h"

namespace fusee::core {

namespace {

constexpr std::size_t kLinesAbove = 60;                     // tried as a header
constexpr std::size_t kMostCells = 2000;                    // of a header; a line with more is no table of ours
constexpr std::size_t kShownCells = 60, kLongestCell = 80;  // of a header in a message
constexpr std::array kSeparators{Separator::kComma, Separator::kSemicolon, Separator::kTab,
                                 Separator::kBar,   Separator::kWide,      Separator::kBlanks};

/// Unit of a column's values: that of its name, or of its list.
struct Wanted {
    Measured name;
    std::vector<const MeasureUnit*> units;  // one for each quantity; empty: a text, or a pure number
};

Wanted wanted_of(const CsvColumn& column) {
    Wanted wanted{measured_name(column.name), {}};
    if (column.kind == CsvColumn::Kind::kText) return {{measured_name(column.name).stem, "", nullptr}, {}};
    if (wanted.name.unit != nullptr) wanted.units.push_back(wanted.name.unit);
    for (const std::string& unit : column.units) wanted.units.push_back(find_measure_unit(unit));
    return wanted;
}

std::string unit_names(const Wanted& wanted) {
    const std::string names = listed(wanted.units, [](const MeasureUnit* unit) { return measure_unit_names(unit->quantity); });
    return names.empty() ? "no unit" : names;
}

/// One header line against the known columns.
class Matcher {
public:
    Matcher(const std::vector<CsvCell>& cells, const std::vector<std::string>& units, const std::vector<CsvColumn>& known,
            const CsvMapping& mapping)
        : cells_(cells), units_(units), known_(known), mapping_(mapping), taken_(cells.size(), false) {
        for (const CsvCell& cell : cells) names_.push_back(measured_name(cell.text));
    }

    HeaderMatch match() {
        std::vector<bool> done(known_.size(), false);
        for (std::size_t k = 0; k < known_.size(); ++k) done[k] = take_told(k);
        for (std::size_t k = 0; k < known_.size(); ++k)
            if (!done[k]) done[k] = take_exact(k);
        for (std::size_t k = 0; k < known_.size(); ++k)
            if (!done[k] && known_[k].header.empty()) done[k] = take_alike(k);
        for (std::size_t k = 0; k < known_.size(); ++k)
            if (!done[k] && known_[k].required) match_.missing.push_back(k);
        std::sort(match_.columns.begin(), match_.columns.end(), [](const auto& a, const auto& b) { return a.cell < b.cell; });
        return std::move(match_);
    }

    [[nodiscard]] std::string unit_text(std::size_t cell) const {
        return names_[cell].unit_text.empty() && cell < units_.size() ? units_[cell] : names_[cell].unit_text;
    }
    [[nodiscard]] const Measured& name(std::size_t cell) const { return names_[cell]; }

private:
    static constexpr std::size_t kNone = std::string::npos;

    [[nodiscard]] std::size_t find(std::string_view header) const {
        const auto cell = std::find_if(cells_.begin(), cells_.end(), [header](const CsvCell& c) { return c.text == header; });
        return cell == cells_.end() ? kNone : static_cast<std::size_t>(cell - cells_.begin());
    }

    /// The header that the user gives for the column: exactly, or with " in UNIT" behind it.
    bool take_told(std::size_t k) {
        const auto own = mapping_.columns.find(known_[k].name);
        const std::string header = own != mapping_.columns.end() ? own->second : known_[k].header;
        if (header.empty()) return false;
        const Wanted wanted = wanted_of(known_[k]);
        std::size_t cell = find(header);
        if (cell != kNone) {
            take(k, cell, known_[k].scale || find_measure_unit(unit_text(cell)) == nullptr ? nullptr : find_measure_unit(unit_text(cell)),
                 wanted, false);
            return true;
        }
        const std::size_t in = header.rfind(" in ");
        if (in == std::string::npos || (cell = find(header.substr(0, in))) == kNone) return false;
        const std::string unit = header.substr(in + 4);
        if (const MeasureUnit* found = find_measure_unit(unit))
            take(k, cell, found, wanted, true);
        else
            fault(cell, fmt::format("unit {} of {} is not known", in_quotes(unit), known_[k].name), unit_names(wanted));
        return true;
    }

    bool take_exact(std::size_t k) {
        const std::size_t cell = find(known_[k].in_header());
        if (cell == kNone) return false;
        const Wanted wanted = wanted_of(known_[k]);
        const MeasureUnit* below = cell < units_.size() ? find_measure_unit(units_[cell]) : nullptr;
        const MeasureUnit* own = wanted.units.size() == 1 ? wanted.units.front() : nullptr;
        if (below != nullptr && own != nullptr && below != own && !known_[k].scale) {
            fault(cell, fmt::format("the header says {}, the row of units {}", own->name, below->name),
                  one_of({{known_[k].name, fmt::format("{} in {}", cells_[cell].text, own->name)},
                          {known_[k].name, fmt::format("{} in {}", cells_[cell].text, below->name)}}));
            taken_[cell] = true;
            return true;
        }
        take(k, cell, own == nullptr && !wanted.units.empty() ? below : nullptr, wanted, false);
        return true;
    }

    /// Takes a name in other capitals, or with the unit in other words.
    bool take_alike(std::size_t k) {
        const Wanted wanted = wanted_of(known_[k]);
        std::vector<std::size_t> fits;
        for (std::size_t cell = 0; cell < cells_.size(); ++cell)
            if (!taken_[cell] && !names_[cell].stem.empty() && names_[cell].stem == wanted.name.stem) fits.push_back(cell);
        if (fits.empty()) return false;
        if (fits.size() > 1) {
            std::string which;
            Entries entries;
            for (const std::size_t cell : fits) {
                which += (which.empty() ? "" : " and ") + in_quotes(cells_[cell].text);
                entries.emplace_back(known_[k].name, std::string(cells_[cell].text));
            }
            fault(fits[1], fmt::format("{} both fit {}", which, known_[k].name), one_of(entries));
            return true;
        }
        const std::size_t cell = fits.front();
        const std::string text = unit_text(cell);
        const MeasureUnit* unit = find_measure_unit(text);
        if (!text.empty() && unit == nullptr && !(wanted.units.empty() && (text == "-" || text == "1"))) {
            fault(cell, fmt::format("unit {} of {} is not known", in_quotes(text), known_[k].name), unit_names(wanted));
        } else if (unit == nullptr && !wanted.units.empty() && known_[k].units.empty()) {
            Entries entries;
            for (const MeasureUnit& each : measure_units(wanted.units.front()->quantity))
                if (entries.size() < 3 || wanted.units.front() == &each)
                    entries.emplace_back(known_[k].name, fmt::format("{} in {}", cells_[cell].text, each.name));
            fault(cell, fmt::format("{} has no unit", in_quotes(cells_[cell].text)), one_of(entries));
        } else {
            take(k, cell, unit, wanted, false);
        }
        return true;
    }

    /// @param unit of the file's numbers; null: that of the column
    void take(std::size_t k, std::size_t cell, const MeasureUnit* unit, const Wanted& wanted, bool told) {
        taken_[cell] = true;
        FoundColumn found{k, cell, known_[k].scale.value_or(1.0), 1.0, {}, told || known_[k].scale.has_value()};
        if (unit != nullptr) {
            const auto same = [unit](const MeasureUnit* each) { return each->converts_to(*unit); };
            const auto to = std::find_if(wanted.units.begin(), wanted.units.end(), same);
            if (to == wanted.units.end()) {
                fault(cell, fmt::format("{} is in {}", in_quotes(cells_[cell].text), unit->name), unit_names(wanted));
                return;
            }
            found.unit = static_cast<std::size_t>(to - wanted.units.begin());
            if (*to != unit) {
                found.numerator = unit->numerator * (*to)->denominator;
                found.denominator = unit->denominator * (*to)->numerator;
            }
        }
        match_.columns.push_back(found);
    }

    using Entries = std::vector<std::pair<std::string, std::string>>;
    [[nodiscard]] std::string one_of(const Entries& entries) const {
        std::string text;
        for (const auto& entry : entries) text += (text.empty() ? "say which: " : " or ") + mapping_.lines({entry});
        return text;
    }
    void fault(std::size_t cell, std::string value, std::string allowed) {
        match_.faults.push_back({cell, std::move(value), std::move(allowed)});
    }

    const std::vector<CsvCell>& cells_;
    const std::vector<std::string>& units_;
    const std::vector<CsvColumn>& known_;
    const CsvMapping& mapping_;
    std::vector<bool> taken_;
    std::vector<Measured> names_;
    HeaderMatch match_;
};

/// Letters that both have in one piece.
std::size_t common_letters(std::string_view a, std::string_view b) {
    std::size_t most = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j) {
            std::size_t n = 0;
            while (i + n < a.size() && j + n < b.size() && a[i + n] == b[j + n]) ++n;
            most = std::max(most, n);
        }
    return most;
}

/// Tries each line and each separator.
class DialectSearch {
public:
    DialectSearch(const std::vector<std::string_view>& lines, const std::vector<CsvColumn>& known, const CsvMapping& mapping)
        : lines_(lines), known_(known), mapping_(mapping) {}

    std::optional<Dialect> find() {
        std::optional<Dialect> best;
        std::size_t most = 0;
        for (std::size_t i = 0; i < std::min(lines_.size(), kLinesAbove) && !complete_; ++i)
            if (!says_nothing(lines_[i])) try_line(i, lines_[i], false, best, most);
        for (std::size_t i = 0; i < std::min(lines_.size(), kLinesAbove) && !complete_; ++i)
            if (const auto text = behind_comment_sign(lines_[i]); !text.empty()) try_line(i, text, true, best, most);
        if (!complete_ && best && best->in_comment) best.reset();
        if (!best) best = by_form();
        if (best) take_units(*best);
        return best;
    }

private:
    void try_line(std::size_t line, std::string_view text, bool in_comment, std::optional<Dialect>& best, std::size_t& most) {
        for (const Separator separator : kSeparators) {
            if (!splitter_.split(text, separator, cells_) || cells_.size() > kMostCells) continue;
            const HeaderMatch match = match_header(cells_, {}, known_, mapping_);
            const std::size_t matched = match.columns.size() + match.faults.size();
            const bool complete = match.missing.empty() && matched > 0;
            if ((complete && !complete_) || (complete == complete_ && matched > most)) {
                best = Dialect{separator, line, in_comment, {}, line + 1};
                most = matched;
                complete_ |= complete;
            }
        }
    }

    [[nodiscard]] std::size_t cells_of(std::size_t line, Separator separator) {
        return line < lines_.size() && splitter_.split(lines_[line], separator, cells_) ? cells_.size() : 0;
    }

    /// No line names a known column: the longest block of lines with as many cells, two or more, has the header above it.
    std::optional<Dialect> by_form() {
        std::optional<Dialect> best;
        std::size_t most = 1;
        for (std::size_t i = 0; i < std::min(lines_.size(), kLinesAbove); ++i) {
            if (says_nothing(lines_[i])) continue;
            if (!best) best = Dialect{Separator::kComma, i, false, {}, i + 1};
            for (const Separator separator :
                 {Separator::kSemicolon, Separator::kTab, Separator::kBar, Separator::kComma, Separator::kWide, Separator::kBlanks}) {
                const std::size_t cells = cells_of(i, separator);
                std::size_t rows = 1;
                while (cells > 1 && rows < kLinesAbove && cells_of(i + rows, separator) == cells) ++rows;
                if (rows > most) {
                    best = Dialect{separator, i, false, {}, i + 1};
                    most = rows;
                }
            }
        }
        return best;
    }

    /// A row of units below the header: no number, half of its cells known units or more.
    void take_units(Dialect& dialect) {
        if (std::none_of(known_.begin(), known_.end(), [](const CsvColumn& c) { return c.kind == CsvColumn::Kind::kNumber; })) return;
        std::size_t line = dialect.header + 1;
        while (line < lines_.size() && says_nothing(lines_[line])) ++line;
        if (cells_of(line, dialect.separator) == 0) return;
        std::vector<std::string> units;
        std::size_t known = 0, filled = 0;
        for (const CsvCell& cell : cells_) {
            if (parse_number(cell.text, '.') || parse_number(cell.text, ',')) return;
            const MeasureUnit* unit = find_measure_unit(cell.text);
            units.push_back(unit != nullptr ? unit->name : cell.text == "-" ? "" : std::string(cell.text));
            filled += units.back().empty() ? 0 : 1;
            known += unit != nullptr ? 1 : 0;
        }
        if (known == 0 || 2 * known < filled) return;
        dialect.units = std::move(units);
        dialect.rows = line + 1;
    }

    const std::vector<std::string_view>& lines_;
    const std::vector<CsvColumn>& known_;
    const CsvMapping& mapping_;
    CellSplitter splitter_;
    std::vector<CsvCell> cells_;
    bool complete_ = false;
};

}  // namespace

HeaderMatch match_header(const std::vector<CsvCell>& cells, const std::vector<std::string>& units, const std::vector<CsvColumn>& known,
                         const CsvMapping& mapping) {
    return Matcher(cells, units, known, mapping).match();
}

std::string unknown_name(const std::vector<CsvColumn>& known, const CsvMapping& mapping) {
    if (!mapping.table.empty()) return "";
    for (const auto& [name, header] : mapping.columns)
        if (std::none_of(known.begin(), known.end(), [&name](const CsvColumn& column) { return column.name == name; })) return name;
    return "";
}

std::string mapping_to_write(const HeaderMatch& match, const std::vector<CsvCell>& cells, const std::vector<std::string>& units,
                             const std::vector<CsvColumn>& known, const CsvMapping& mapping) {
    // What has long or unprintable cells is no header.
    if (cells.size() > kShownCells ||
        std::any_of(cells.begin(), cells.end(), [](const CsvCell& cell) { return printable(cell.text, kLongestCell) != cell.text; }))
        return "";
    const Matcher names(cells, units, known, mapping);
    std::set<std::size_t> used;
    for (const FoundColumn& column : match.columns) used.insert(column.cell);
    std::string header;
    std::vector<std::size_t> free;
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        if (cells[cell].text.empty()) continue;
        header += (header.empty() ? "" : ", ") + in_quotes(cells[cell].text);
        if (!used.contains(cell)) free.push_back(cell);
    }
    if (free.empty()) return "";
    std::vector<std::pair<std::string, std::string>> entries;
    for (const std::size_t k : match.missing) {
        const Wanted wanted = wanted_of(known[k]);
        const auto score = [&](std::size_t cell) {
            const MeasureUnit* unit = find_measure_unit(names.unit_text(cell));
            const bool fits = unit == nullptr ? wanted.units.empty()
                                              : std::any_of(wanted.units.begin(), wanted.units.end(),
                                                            [unit](const auto* w) { return w->converts_to(*unit); });
            const bool same_kind = fits || (unit == nullptr && !wanted.units.empty());
            return (fits ? 1000 : same_kind ? 100 : 0) + common_letters(wanted.name.stem, names.name(cell).stem);
        };
        const auto best = std::max_element(free.begin(), free.end(), [&](auto a, auto b) { return score(a) < score(b); });
        const bool none = best == free.end() || score(*best) < 100;
        std::string text = none ? "HEADER" : std::string(cells[*best].text);
        if (!none && score(*best) < 1000) text += " in UNIT";
        entries.emplace_back(known[k].name, std::move(text));
        if (!none) free.erase(best);
    }
    return fmt::format("; in the file: {}; where one of them is meant: {}", header, mapping.lines(entries));
}

std::optional<Dialect> find_dialect(const std::vector<std::string_view>& lines, const std::vector<CsvColumn>& known,
                                    const CsvMapping& mapping) {
    return DialectSearch(lines, known, mapping).find();
}

std::string count_of_columns(std::size_t count) {
    constexpr std::array<const char*, 10> kWords{"no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine"};
    return fmt::format("{} column{}", count < kWords.size() ? kWords[count] : fmt::format("{}", count), count == 1 ? "" : "s");
}

}  // namespace fusee::core
