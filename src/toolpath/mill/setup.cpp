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

}  // namespace fusee::toolpath::mill
