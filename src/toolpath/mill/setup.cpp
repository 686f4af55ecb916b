#include "mill/setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "fusee/core/error.h"
#include "fusee/core/units.h"

namespace fusee::toolpath::mill {

namespace {

/// The numbers of a comment from a word on.
std::vector<double> numbers(const Program& program, const Comment& comment, std::size_t from, std::size_t count) {
    std::vector<double> values;
    for (std::size_t i = from; i < comment.words.size(); ++i) {
        const std::string& w = comment.words[i];
        double value = 0.0;
        if (std::from_chars(w.data(), w.data() + w.size(), value).ec == std::errc()) values.push_back(value);
    }
    if (values.size() != count)
        throw core::IoError(program.name, fmt::format("line {}: the comment \"{}\" must hold {} numbers", comment.line,
                                                      fmt::format("{} {}", comment.words[0], comment.words[1]), count));
    return values;
}

/// "tool N end D FLUTE SHANK STICK HOLDER", "tool N form NOSE_D HALF_DEG WIDTH FLUTE SHANK STICK HOLDER",
/// "tool N cone TIP_D LEAD D FLUTE SHANK STICK HOLDER"
Tool tool_of(const Program& program, const Comment& comment) {
    const bool form = comment.words[2] == "form", cone = comment.words[2] == "cone";
    const auto v = numbers(program, comment, 3, form || cone ? 7 : 5);
    Tool tool;
    const std::size_t rest = form || cone ? 3 : 1;
    tool.radius = 0.5 * v[rest - 1];
    if (cone) tool.tip = 0.5 * v[0], tool.lead = v[1];
    if (form) {
        const double half_angle = core::rad_from_deg(v[1]);
        tool.nose = 0.5 * v[0];
        tool.flank = {std::sin(half_angle), std::cos(half_angle), std::tan(half_angle)};
    }
    tool.flute = v[rest], tool.shank = 0.5 * v[rest + 1], tool.stick_out = v[rest + 2], tool.holder = 0.5 * v[rest + 3];
    return tool;
}

/// "hole X Y D BOTTOM", "index X Y D BOTTOM"
Hole hole_of(const Program& program, const Comment& comment) {
    const auto v = numbers(program, comment, 1, 4);
    return {comment.line, v[0], v[1], 0.5 * v[2], v[3]};
}

template <std::size_t N>
std::array<double, N> first(const std::vector<double>& values) {
    std::array<double, N> result{};
    std::copy_n(values.begin(), N, result.begin());
    return result;
}

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

double Tool::radius_at(double s) const {
    if (lead > 0.0) return std::min(radius, tip + (radius - tip) * s / lead);
    if (nose <= 0.0) return radius;
    const double touch = nose * (1.0 - flank.sine);
    if (s < touch) return std::min(radius, std::sqrt(std::max(0.0, s * (2.0 * nose - s))));
    return std::min(radius, nose * flank.cosine + (s - touch) * flank.tangent);
}

double Tool::end_at(double r) const {
    if (lead > 0.0) return r <= tip ? 0.0 : lead * (r - tip) / (radius - tip);
    if (nose <= 0.0) return 0.0;
    const double touch = nose * flank.cosine;
    if (r <= touch) return nose - std::sqrt(std::max(0.0, nose * nose - r * r));
    return nose * (1.0 - flank.sine) + (r - touch) / flank.tangent;
}

Setup::Setup(const Program& program) {
    for (const Comment& comment : program.comments) {
        const auto& w = comment.words;
        if (w.size() < 2) continue;
        const std::string begin = w[0] + " " + w[1];
        if (w[0] == "tool" && w.size() >= 8 && (w[2] == "end" || w[2] == "form" || w[2] == "cone"))
            tools[std::atoi(w[1].c_str())] = tool_of(program, comment);
        if (begin == "stock box") box = first<6>(numbers(program, comment, 2, 6));
        if (begin == "stock round") round = first<3>(numbers(program, comment, 2, 3));
        if (w[0] == "board" && w.size() == 3) board = first<2>(numbers(program, comment, 1, 2));
        if (w[0] == "rotary" && w.size() == 2) rotary = numbers(program, comment, 1, 1)[0];
        if (w[0] == "hole" && w.size() == 5) holes.push_back(hole_of(program, comment));
        if (w[0] == "index" && w.size() == 5) index.push_back(hole_of(program, comment));
        if (w[0] == "index") index_stated = true;
        if (w[0] == "A:") index_a = numbers(program, comment, w.size() - 1, 1)[0];  // "A: turn the index pin ...; there A is 95.000"
        if (begin == "held box") {
            const auto v = numbers(program, comment, 2, 4);
            held.push_back({false, {v[0], v[1]}, {v[2], v[3]}, 0.0});
        }
        if (begin == "clamp box") {
            const auto v = numbers(program, comment, 2, 5);
            clamps.push_back({false, {v[0], v[1]}, {v[2], v[3]}, v[4]});
        }
        if (begin == "clamp round") {
            const auto v = numbers(program, comment, 2, 3);
            clamps.push_back({true, {v[1], v[2]}, {}, v[0]});
        }
    }
}

Stock Setup::stock(const Program& program, double cell_mm) const {
    if (box) {
        const auto& b = *box;
        Stock stock(b[0], b[1], b[2], b[3], cell_mm);
        std::fill(stock.cells.begin(), stock.cells.end(), std::vector<Stock::Interval>{{b[4], b[5]}});
        return stock;
    }
    if (!round) throw core::IoError(program.name, "no comment states the stock");
    const auto& [radius, low, high] = *round;
    Stock stock(-radius, radius, -radius, radius, cell_mm);
    for (std::size_t j = 0; j < stock.rows; ++j)
        for (std::size_t i = 0; i < stock.columns; ++i)
            if (std::hypot(stock.x_of(i), stock.y_of(j)) <= radius) stock.cells[j * stock.columns + i] = {{low, high}};
    return stock;
}

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
