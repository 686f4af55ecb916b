#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fields.h"
#include "fusee/core/file.h"

namespace fusee::gap_case {

namespace {

/// True if the column is written: optional columns need a value in at least one row.
template <class Row>
bool stands(const Field<Row>& field, const std::vector<Row>& rows, const Rows& all) {
    if (field.required) return true;
    if constexpr (std::is_same_v<Row, DeadBandRow>) {
        const bool width = std::string_view(field.column) == "width_rad";
        if (field.measured) return width == all.dead_band_width_only;
        const bool once = std::all_of(rows.begin(), rows.end(), [](const Row& row) { return row.repeat == 1; });
        if (field.quantity == Quantity::kCount && all.dead_band_width_only && once) return false;
    }
    return std::any_of(rows.begin(), rows.end(), [&field](const Row& row) { return !std::isnan(field.get(row)); });
}

/// The shortest digits that give the number back; nothing for NaN.
template <class Row>
std::string cell(const Field<Row>& field, const Row& row) {
    const double value = field.get(row);
    if (!field.words.empty()) return field.words[static_cast<std::size_t>(value)];
    return std::isnan(value) ? "" : fmt::format("{}", value);
}

template <class Row>
std::string csv(const std::vector<Row>& rows, std::size_t begin, std::size_t end, const Rows& all) {
    std::vector<const Field<Row>*> columns;
    std::vector<std::string> cells;
    for (const Field<Row>& field : fields<Row>()) {
        if (!stands(field, rows, all)) continue;
        columns.push_back(&field);
        cells.emplace_back(field.column);
    }
    std::string text = fmt::format("{}\n", fmt::join(cells, ","));
    for (std::size_t i = begin; i < end; ++i) {
        for (std::size_t k = 0; k < columns.size(); ++k) cells[k] = cell(*columns[k], rows[i]);
        text += fmt::format("{}\n", fmt::join(cells, ","));
    }
    return text;
}

template <class Row>
Column column_of(const Field<Row>& field, const std::vector<Row>& rows) {
    if (field.words.empty()) {
        std::vector<double> numbers;
        for (const Row& row : rows) numbers.push_back(field.get(row));
        return {field.column, std::move(numbers)};
    }
    std::vector<std::string> words;
    for (const Row& row : rows) words.push_back(field.words[static_cast<std::size_t>(field.get(row))]);
    return {field.column, std::move(words)};
}

}  // namespace

CaseTexts row_texts(const Case& nominal, const Rows& rows) {
    CaseTexts texts;
    for_each_experiment(rows, [&](Experiment experiment, const auto& all) {
        const auto named = nominal.files.find(experiment);
        if (named == nominal.files.end() || all.empty()) return;
        std::vector<std::size_t> parts(named->second.size(), 0);
        parts.front() = all.size();
        if (const auto known = rows.parts.find(experiment);
            known != rows.parts.end() && std::accumulate(known->second.begin(), known->second.end(), std::size_t{0}) == all.size())
            parts = known->second;
        std::size_t begin = 0;
        for (std::size_t i = 0; i < parts.size(); begin += parts[i], ++i)
            if (parts[i] > 0) texts[named->second.at(i)] = csv(all, begin, begin + parts[i], rows);
    });
    return texts;
}

void write_rows(const Case& nominal, const Rows& rows, const fs::path& folder) {
    for (const auto& [name, text] : row_texts(nominal, rows)) {
        core::make_folder((folder / name).parent_path());
        core::write_file(folder / name, text);
    }
}

std::vector<Column> columns_of(const Rows& rows, Experiment experiment) {
    std::vector<Column> columns;
    for_each_experiment(rows, [&]<class Row>(Experiment other, const std::vector<Row>& all) {
        if (other != experiment || all.empty()) return;
        for (const Field<Row>& field : fields<Row>())
            if (stands(field, all, rows)) columns.push_back(column_of(field, all));
    });
    return columns;
}

}  // namespace fusee::gap_case
