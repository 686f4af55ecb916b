#include <algorithm>
#include <cmath>

#include "fusee/toolpath/mill.h"

namespace fusee::toolpath::mill {

namespace {

constexpr double kThin_mm = 0.05;  // beyond a tab

std::size_t count_of(double low, double high, double cell) { return static_cast<std::size_t>(std::ceil((high - low) / cell)); }

}  // namespace

Stock::Stock(double x_from, double x_to, double y_from, double y_to, double cell_mm)
    : x_low(x_from),
      y_low(y_from),
      cell(cell_mm),
      columns(count_of(x_from, x_to, cell_mm)),
      rows(count_of(y_from, y_to, cell_mm)),
      cells(columns * rows) {}

const std::vector<Stock::Interval>& Stock::at(double x, double y) const {
    static const std::vector<Interval> none;
    const double i = std::floor((x - x_low) / cell), j = std::floor((y - y_low) / cell);
    if (i < 0.0 || j < 0.0 || i >= static_cast<double>(columns) || j >= static_cast<double>(rows)) return none;
    return cells[static_cast<std::size_t>(j) * columns + static_cast<std::size_t>(i)];
}

std::optional<double> Stock::top(double x, double y) const {
    const auto& material = at(x, y);
    return material.empty() ? std::nullopt : std::optional(material.back()[1]);
}

double Stock::remove(std::size_t which, double low, double high) {
    std::vector<Interval>& material = cells[which];
    double removed = 0.0;
    for (std::size_t i = 0; i < material.size();) {
        Interval& one = material[i];
        const double from = std::max(low, one[0]), to = std::min(high, one[1]);
        if (to <= from) {
            ++i;
            continue;
        }
        removed += to - from;
        const Interval above{to, one[1]};
        one[1] = from;
        const bool keeps_below = one[1] > one[0], keeps_above = above[1] > above[0];
        if (keeps_above && keeps_below) {
            material.insert(material.begin() + static_cast<long>(i) + 1, above);
            i += 2;
        } else if (keeps_above) {
            one = above;
            ++i;
        } else if (keeps_below) {
            ++i;
        } else {
            material.erase(material.begin() + static_cast<long>(i));
        }
    }
    return removed;
}

std::array<std::size_t, 2> Stock::span(double low, double high, double origin, std::size_t count) const {
    const auto index = [&](double place) {
        return static_cast<std::size_t>(std::clamp(std::floor((place - origin) / cell), 0.0, static_cast<double>(count)));
    };
    return {index(low), std::min(count, index(high) + 1)};
}

Stock released(Stock stock, double tab_height_mm) {
    const auto thickness = [](const std::vector<Stock::Interval>& cell) {
        double sum = 0.0;
        for (const auto& one : cell) sum += one[1] - one[0];
        return sum;
    };
    std::size_t start = 0;
    double nearest = 1e9;
    for (std::size_t cell = 0; cell < stock.cells.size(); ++cell) {
        if (thickness(stock.cells[cell]) <= tab_height_mm + kThin_mm) stock.cells[cell].clear();
        const double away = std::hypot(stock.x_of(cell % stock.columns), stock.y_of(cell / stock.columns));
        if (!stock.cells[cell].empty() && away < nearest) nearest = away, start = cell;
    }
    std::vector<char> kept(stock.cells.size(), 0);
    for (std::vector<std::size_t> open{start}; !open.empty();) {
        const std::size_t cell = open.back(), column = cell % stock.columns;
        open.pop_back();
        if (kept[cell] || stock.cells[cell].empty()) continue;
        kept[cell] = 1;
        if (column > 0) open.push_back(cell - 1);
        if (column + 1 < stock.columns) open.push_back(cell + 1);
        if (cell >= stock.columns) open.push_back(cell - stock.columns);
        if (cell + stock.columns < stock.cells.size()) open.push_back(cell + stock.columns);
    }
    for (std::size_t cell = 0; cell < stock.cells.size(); ++cell)
        if (!kept[cell]) stock.cells[cell].clear();
    return stock;
}

}  // namespace fusee::toolpath::mill
