#include "csv.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>

#include "fusee/core/error.h"

namespace fusee::profile {

namespace {

constexpr std::array<std::string_view, 3> kColumns{"angle_rad", "series_Nm", "parallel_Nm"};
constexpr std::string_view kHeader = "angle_rad,series_Nm,parallel_Nm";
constexpr std::size_t kLeastRows = 8;  // spring::make_tabulated needs as many
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

struct Cell {
    std::string_view text;
    std::size_t column;  // of its first character, from 1
};

std::vector<Cell> split(std::string_view line) {
    std::vector<Cell> cells;
    for (std::size_t begin = 0; begin <= line.size();) {
        const std::size_t end = std::min(line.find(',', begin), line.size());
        std::size_t first = begin, last = end;
        while (first < last && (line[first] == ' ' || line[first] == '\t')) ++first;
        while (last > first && (line[last - 1] == ' ' || line[last - 1] == '\t')) --last;
        cells.push_back({line.substr(first, last - first), first + 1});
        begin = end + 1;
    }
    return cells;
}

[[noreturn]] void refuse(const std::string& file, std::size_t line, std::size_t column, std::string_view what, std::string value,
                         const std::string& allowed) {
    throw core::InvalidInput(fmt::format("{}:{}:{}: {}", file, line, column, what), std::move(value), allowed);
}

double parse(const std::string& file, std::size_t line, const Cell& cell, std::string_view column) {
    if (cell.text.empty()) refuse(file, line, cell.column, column, "(missing)", "a finite number in every row");
    std::string_view digits = cell.text;
    if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value))
        refuse(file, line, cell.column, column, fmt::format("'{}'", cell.text), "a finite number with a decimal point");
    return value;
}

void check_header(const std::string& file, std::size_t line, std::string_view text) {
    const std::vector<Cell> cells = split(text);
    for (std::size_t i = 0; i < kColumns.size(); ++i)
        if (i >= cells.size() || cells[i].text != kColumns[i])
            refuse(file, line, i < cells.size() ? cells[i].column : text.size() + 1, "header",
                   i < cells.size() ? fmt::format("'{}'", cells[i].text) : "(missing)", fmt::format("'{}'", kHeader));
    if (cells.size() > kColumns.size()) refuse(file, line, cells[3].column, "header", fmt::format("'{}'", cells[3].text), "three columns");
}

void read_row(const std::string& file, std::size_t line, std::string_view text, TablePair& table) {
    const std::vector<Cell> cells = split(text);
    std::array<double, 3> row{};
    for (std::size_t i = 0; i < row.size(); ++i)
        row[i] = parse(file, line, i < cells.size() ? cells[i] : Cell{{}, text.size() + 1}, kColumns[i]);
    if (cells.size() > row.size()) refuse(file, line, cells[3].column, "row", fmt::format("'{}'", cells[3].text), "three columns");
    if (!table.angle.empty() && row[0] <= table.angle.back())
        refuse(file, line, cells[0].column, kColumns[0], fmt::format("{:g}", row[0]),
               fmt::format("above the row before, {:g}", table.angle.back()));
    table.angle.push_back(row[0]);
    table.series.push_back(row[1]);
    table.parallel.push_back(row[2]);
}

}  // namespace

void read_table(std::string_view csv, const std::string& file, TablePair& table) {
    if (csv.starts_with(kByteOrderMark)) csv.remove_prefix(kByteOrderMark.size());
    bool headed = false;
    std::size_t line = 0;
    while (!csv.empty()) {
        const std::size_t end = std::min(csv.find('\n'), csv.size());
        std::string_view text = csv.substr(0, end);
        csv.remove_prefix(std::min(end + 1, csv.size()));
        ++line;
        if (text.ends_with('\r')) text.remove_suffix(1);
        if (text.find_first_not_of(" \t") == std::string_view::npos || text.starts_with('#')) continue;
        if (headed)
            read_row(file, line, text, table);
        else
            check_header(file, line, text);
        headed = true;
    }
    if (!headed) refuse(file, 1, 1, "header", "(missing)", fmt::format("'{}'", kHeader));
    if (table.angle.size() < kLeastRows)
        refuse(file, line, 1, "rows", fmt::format("{}", table.angle.size()), fmt::format("at least {}", kLeastRows));
}

}  // namespace fusee::profile
