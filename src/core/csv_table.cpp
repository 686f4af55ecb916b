#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <charconv>

#include "csv_text.h"
#include "fusee/core/csv.h"
#include "fusee/core/lists.h"
#include "fusee/core/text.h"

namespace fusee::core {

namespace {

constexpr std::size_t kMostFaults = 20;  // that are reported one by one

constexpr auto kNameOf = [](const auto& column) -> std::string_view { return column.known.name; };

}  // namespace

bool CsvTable::has(std::string_view name) const { return find_by(columns_, kNameOf, name) != nullptr; }

const CsvTable::Column& CsvTable::column(std::string_view name) const {
    const Column* found = find_by(columns_, kNameOf, name);
    assert(found != nullptr);
    return *found;
}

const std::vector<double>& CsvTable::numbers(std::string_view name) const {
    assert(column(name).known.kind == CsvColumn::Kind::kNumber);
    return column(name).numbers;
}

const std::vector<std::string>& CsvTable::texts(std::string_view name) const {
    assert(column(name).known.kind == CsvColumn::Kind::kText);
    return column(name).texts;
}

InvalidInput CsvTable::fault(std::size_t row, std::string_view name, std::string value, std::string allowed) const {
    const Column& faulty = column(name);
    if (faulty.numerator != faulty.denominator && faulty.known.kind == CsvColumn::Kind::kNumber)
        value = fmt::format("{:g}, which is {} as {}", faulty.numbers.at(row) * faulty.denominator / faulty.numerator, value, name);
    return fault_at(file_, lines_.at(row), faulty.places.at(row), faulty.header, std::move(value), std::move(allowed));
}

InvalidInput CsvTable::question(std::size_t row, std::string_view name, std::string_view asked, std::string_view why) const {
    const Column& c = column(name);
    const MeasureUnit* unit = find_measure_unit(asked);
    const auto own = std::find_if(c.known.units.begin(), c.known.units.end(), [unit](const std::string& each) {
        return unit != nullptr && find_measure_unit(each)->converts_to(*unit);
    });
    const MeasureUnit* named = own != c.known.units.end() ? find_measure_unit(*own) : measured_name(c.known.name).unit;
    const MeasureUnit* headed = measured_name(c.header).unit;
    const auto line = [&](std::string_view in) { return mapping_.lines({{c.known.name, fmt::format("{} in {}", c.header, in)}}); };
    return fault_at(file_, lines_.at(row), c.places.at(row), c.header, fmt::format("{:g}; {}", c.numbers.at(row), why),
                    fmt::format("are these {}? Say which: {} or {}", asked == "deg" ? "degrees" : asked, line(asked),
                                line(headed != nullptr  ? headed->name
                                     : named != nullptr ? named->name
                                                        : "?")));
}

void CsvMapping::add(const std::string& name, const std::string& header, const std::string& place) {
    if (name == "decimal") {
        if (header != "," && header != ".") throw InvalidInput(place, in_quotes(header), "decimal = , or .");
        decimal = header.front();
    } else if (header.empty() || !columns.emplace(name, header).second) {
        throw InvalidInput(place, header.empty() ? "no header" : in_quotes(name) + " twice", "NAME=HEADER of the file, each name once");
    }
}

CsvMapping CsvMapping::of(const std::vector<std::string>& entries) {
    CsvMapping mapping;
    for (const std::string& entry : entries) {
        const std::size_t equals = entry.find('=');
        if (equals == std::string::npos || equals == 0)
            throw InvalidInput("--columns", in_quotes(entry), "NAME=HEADER, \"angle_rad=Winkel in deg\", or decimal=, or decimal=.");
        mapping.add(entry.substr(0, equals), entry.substr(equals + 1), "--columns");
    }
    return mapping;
}

std::string CsvMapping::lines(const std::vector<std::pair<std::string, std::string>>& entries) const {
    std::string text;
    for (const auto& [name, header] : entries) {
        std::string quoted = printable(header);
        for (std::size_t at = quoted.find_first_of("\"\\"); !table.empty() && at != std::string::npos;
             at = quoted.find_first_of("\"\\", at + 2))
            quoted.insert(at, "\\");
        text += table.empty() ? fmt::format("{}--columns {}", text.empty() ? "" : " ", shell_word(fmt::format("{}={}", name, quoted)))
                              : fmt::format("{}{} = \"{}\"", text.empty() ? "" : ", ", name, quoted);
    }
    return table.empty() ? text : fmt::format("{} = {{ {} }}", table, text);
}

std::string csv_cell(std::string_view text) {
    // A spreadsheet takes these for a formula, which may start programs; the apostrophe makes it a text there.
    double number = 0.0;
    const char* const end = text.data() + text.size();
    const std::size_t sign = !text.empty() && text.front() == '+' ? 1 : 0;  // from_chars takes no plus
    const bool is_formula = text.size() > 1 && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos &&
                            std::from_chars(text.data() + sign, end, number).ptr != end;
    if (!is_formula && text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
    std::string cell = is_formula ? "\"'" : "\"";
    for (const char c : text) cell += c == '"' ? "\"\"" : std::string(1, c);
    return cell + '"';
}

void CsvFaults::add(InvalidInput fault) {
    if (count_++ < kMostFaults) first_.add(std::move(fault));
}

void CsvFaults::throw_if_any() const {
    Mistakes all = first_;
    if (count_ > kMostFaults) all.add(InvalidInput(file_, fmt::format("and {} more", count_ - kMostFaults), "none"));
    all.throw_if_any();
}

}  // namespace fusee::core
