#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"
#include "mill/setup.h"

namespace fusee::toolpath::mill {

namespace {

constexpr double kCrumb_mm2 = 1.0;          // a smaller piece is a chip
constexpr double kRim_mm = 0.02;            // of a hole, not looked at
constexpr double kHoleAllowance_mm = 0.02;  // of material left in a hole
constexpr double kIndexAllowance_mm = 0.01;

/// How much material stands in a hole above its bottom, where most [mm].
double left_in(const Stock& stock, const Hole& hole) {
    double left = 0.0;
    const double radius = hole.radius - kRim_mm;  // distances of the middles of cells are exact
    const auto columns = stock.span(hole.x - radius, hole.x + radius, stock.x_low, stock.columns);
    const auto rows = stock.span(hole.y - radius, hole.y + radius, stock.y_low, stock.rows);
    for (std::size_t j = rows[0]; j < rows[1]; ++j)
        for (std::size_t i = columns[0]; i < columns[1]; ++i) {
            if (std::hypot(stock.x_of(i) - hole.x, stock.y_of(j) - hole.y) > radius) continue;
            double here = 0.0;
            for (const auto& one : stock.cells[j * stock.columns + i]) here += std::max(0.0, one[1] - std::max(one[0], hole.bottom));
            left = std::max(left, here);
        }
    return left;
}

/// How far the index is from the side of +Y, level with the axis, at the stated A [mm].
double index_off(const Setup& setup, const Hole& hole) {
    const double angle = std::atan2(hole.y, hole.x) + setup.rotary * core::rad_from_deg(setup.index_a.value_or(0.0));
    const double away = std::hypot(hole.x, hole.y);
    return std::hypot(away + away * std::sin(angle), away * std::cos(angle));
}

bool above(const Stock& stock, std::size_t cell, const Clamp& place) {
    const double x = stock.x_of(cell % stock.columns), y = stock.y_of(cell / stock.columns);
    return !place.round && x >= place.x[0] && x <= place.x[1] && y >= place.y[0] && y <= place.y[1];
}

bool is_held(const Setup& setup, const Stock& stock, std::size_t cell) {
    const auto holds = [&](const Clamp& place) { return above(stock, cell, place); };
    return std::any_of(setup.held.begin(), setup.held.end(), holds) ||
           std::any_of(setup.clamps.begin(), setup.clamps.end(), [&](const Clamp& c) { return c.top > 0.0 && holds(c); });
}

bool meet(const std::vector<Stock::Interval>& a, const std::vector<Stock::Interval>& b) {
    return std::any_of(a.begin(), a.end(), [&](const Stock::Interval& one) {
        return std::any_of(b.begin(), b.end(),
                           [&](const Stock::Interval& other) { return std::max(one[0], other[0]) < std::min(one[1], other[1]); });
    });
}

/// Area of the greatest piece that is not held [mm2]. Columns of material are one piece with those beside them that they meet.
double greatest_free_piece(const Setup& setup, const Stock& stock) {
    std::vector<char> seen(stock.cells.size(), 0);
    double greatest = 0.0;
    for (std::size_t start = 0; start < stock.cells.size(); ++start) {
        bool held = false;
        std::size_t count = 0;
        for (std::vector<std::size_t> open{start}; !open.empty();) {
            const std::size_t cell = open.back(), column = cell % stock.columns;
            open.pop_back();
            if (seen[cell] || stock.cells[cell].empty()) continue;
            seen[cell] = 1;
            ++count;
            held = held || is_held(setup, stock, cell);
            const auto join = [&](std::size_t next) {
                if (!seen[next] && meet(stock.cells[cell], stock.cells[next])) open.push_back(next);
            };
            if (column > 0) join(cell - 1);
            if (column + 1 < stock.columns) join(cell + 1);
            if (cell >= stock.columns) join(cell - stock.columns);
            if (cell + stock.columns < stock.cells.size()) join(cell + stock.columns);
        }
        if (!held) greatest = std::max(greatest, static_cast<double>(count) * stock.cell * stock.cell);
    }
    return greatest;
}

std::size_t last_cut(const Program& program) {
    const auto found = std::find_if(program.moves.rbegin(), program.moves.rend(), [](const Move& m) { return !m.rapid && m.to.z < 0.0; });
    return found == program.moves.rend() ? 0 : found->line;
}

}  // namespace

std::vector<Contact> faults_of(const Setup& setup, const Stock& stock, const Program& program) {
    std::vector<Contact> faults;
    for (const Hole& hole : setup.holes)
        if (const double left = left_in(stock, hole); left > kHoleAllowance_mm)
            faults.push_back({"millsim.hole", "a hole is not at its full diameter down to its bottom", hole.line, left, 1});
    if (const double area = greatest_free_piece(setup, stock); area > kCrumb_mm2)
        faults.push_back({"millsim.free", "a piece of the stock is cut free: neither clamp nor tab holds it", last_cut(program), area, 1});
    return faults;
}

std::vector<Contact> index_faults(const Setup& setup, const Stock& blank) {
    if (!setup.index_stated) return {{"millsim.index", "nothing on the blank says where A0 is", 1, 1.0, 1}};
    std::vector<Contact> faults;
    for (const Hole& hole : setup.index) {
        if (const double left = left_in(blank, hole); left > kHoleAllowance_mm)
            faults.push_back({"millsim.index", "the blank does not bring the hole by which A0 is set", hole.line, left, 1});
        if (const double off = index_off(setup, hole); off > kIndexAllowance_mm)
            faults.push_back({"millsim.index", "the index is not at +Y, level with the axis, at the A that is stated", hole.line, off, 1});
    }
    return faults;
}

}  // namespace fusee::toolpath::mill
