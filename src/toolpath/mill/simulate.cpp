#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "mill/setup.h"
#include "words.h"

namespace fusee::toolpath::mill {

namespace {

constexpr double kTouch_mm = 2e-3;   // cutters may run along a surface; arcs are chords
constexpr double kChords_mm = 0.01;  // a shank as thick as its cutter runs along the wall that chords leave
constexpr int kDirections = 720;     // in which the blank's extent is known

/// Lengths of material that one move meets with each section of the tool.
struct Met {
    double cutter = 0.0, shank = 0.0, holder = 0.0;
    double blunt = 0.0;  ///< a reamer's end, which does not cut
};

class Simulation {
public:
    Simulation(const Program& program, double cell, const Stock* blank, double lift)
        : program_(program), setup_(program), stock_(blank ? *blank : setup_.stock(program, cell)) {
        for (auto& material : stock_.cells)
            for (auto& one : material) {
                if (blank) one[0] += lift, one[1] += lift;
                top_ = std::max(top_, one[1]);
            }
        contacts_ = program.faults;
        if (blank && setup_.rotary != 0.0) add(index_faults(setup_, stock_));
        if (setup_.rotary != 0.0) measure_extents();
    }

    void run() {
        for (const Move& move : program_.moves) {
            minutes_ += move.minutes;
            const Tool& tool = tool_of(move);
            const Met met = setup_.rotary == 0.0 ? cut(move, tool) : cut_on_rotary_axis(move, tool);
            if (move.rapid && met.cutter > kTouch_mm) report("millsim.rapid", "a rapid move passes through the stock", move, met.cutter);
            if (met.shank > kTouch_mm) report("millsim.shank", "the shank above the flutes touches the stock", move, met.shank);
            if (met.blunt > kTouch_mm) report("millsim.reamer", "a reamer is pushed deeper than its hole is drilled", move, met.blunt);
            if (met.holder > 0.0) report("millsim.holder", "the holder touches the stock", move, met.holder);
            hit_clamps(move, tool);
        }
        if (setup_.rotary == 0.0) add(faults_of(setup_, stock_, program_));
    }
    [[nodiscard]] Result done() && { return {std::move(stock_), std::move(contacts_), minutes_}; }

private:
    const Tool& tool_of(const Move& move) const {
        const auto tool = setup_.tools.find(move.tool);
        if (tool == setup_.tools.end())
            throw core::IoError(program_.name,
                                "line " + std::to_string(move.line) + ": no comment describes tool " + std::to_string(move.tool));
        return tool->second;
    }

    void add(const std::vector<Contact>& more) { contacts_.insert(contacts_.end(), more.begin(), more.end()); }

    void report(const char* rule, const char* what, const Move& move, double measured) {
        const auto same = std::find_if(contacts_.begin(), contacts_.end(), [&](const Contact& c) { return c.rule == rule; });
        if (same == contacts_.end()) return contacts_.push_back({rule, what, move.line, measured, 1});
        same->measured = std::max(same->measured, measured);
        ++same->moves;
    }

    void hit_clamps(const Move& move, const Tool& tool) {
        const double way = std::hypot(move.to.x - move.from.x, move.to.y - move.from.y, move.to.z - move.from.z);
        const int steps = 1 + static_cast<int>(way / 0.5);
        double deepest = 0.0, in_board = 0.0, low = 0.0;
        if (move.rapid && (move.to.x != move.from.x || move.to.y != move.from.y))
            for (const Clamp& clamp : setup_.clamps) low = std::max(low, clamp.top - std::min(move.from.z, move.to.z));
        if (low > 0.0) report("millsim.safe_height", "a rapid move across runs lower than the top of the clamps", move, low);
        for (int i = 0; i <= steps; ++i) {
            const Pose pose = between(move.from, move.to, static_cast<double>(i) / steps);
            for (const Clamp& clamp : setup_.clamps) deepest = std::max(deepest, overlap(tool, pose, clamp));
            if (setup_.board) in_board = std::max(in_board, (*setup_.board)[0] - pose.z - tool.lead);
        }
        if (deepest > 0.0) report("millsim.clamp", "cutter, shank or holder hits a clamp or the chuck", move, deepest);
        if (setup_.board && in_board > (*setup_.board)[1] + kTouch_mm)
            report("millsim.board", "the cutter plunges too deep into the board", move, in_board - (*setup_.board)[1]);
    }

    /// Three axes: everything above the cutter's end is removed. The distance of a cell from the path is exact.
    Met cut(const Move& move, const Tool& tool) {
        Met met;
        const Pose &a = move.from, &b = move.to;
        if (std::min(a.z, b.z) > top_) return met;
        const bool low_holder = std::min(a.z, b.z) + tool.stick_out < top_;
        const double reach = std::max(low_holder ? tool.holder : 0.0, std::max(tool.radius, tool.shank));
        const auto columns = stock_.span(std::min(a.x, b.x) - reach, std::max(a.x, b.x) + reach, stock_.x_low, stock_.columns);
        const auto rows = stock_.span(std::min(a.y, b.y) - reach, std::max(a.y, b.y) + reach, stock_.y_low, stock_.rows);
        const double dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
        for (std::size_t j = rows[0]; j < rows[1]; ++j)
            for (std::size_t i = columns[0]; i < columns[1]; ++i) {
                const auto& material = stock_.cells[j * stock_.columns + i];
                if (material.empty()) continue;
                const double x = stock_.x_of(i) - a.x, y = stock_.y_of(j) - a.y;
                const double s = length2 > 0.0 ? std::clamp((x * dx + y * dy) / length2, 0.0, 1.0) : (b.z < a.z ? 1.0 : 0.0);
                const double r2 = (x - s * dx) * (x - s * dx) + (y - s * dy) * (y - s * dy), z = a.z + s * (b.z - a.z);
                if (r2 > reach * reach) continue;
                const double high = material.back()[1], r = std::sqrt(r2);
                if (r < tool.holder) met.holder = std::max(met.holder, high - z - tool.stick_out);
                if (r < tool.shank - kChords_mm) met.shank = std::max(met.shank, high - z - tool.flute);
                if (r >= tool.radius || z >= high) continue;
                const double removed = stock_.remove(j * stock_.columns + i, z + tool.end_at(r), 1e9);
                met.cutter = std::max(met.cutter, removed);
                if (r < tool.tip) met.blunt = std::max(met.blunt, removed);
            }
        return met;
    }

    void measure_extents() {
        extents_.assign(kDirections, 0.0);
        for (std::size_t j = 0; j < stock_.rows; ++j)
            for (std::size_t i = 0; i < stock_.columns; ++i)
                if (!stock_.cells[j * stock_.columns + i].empty()) outer_.push_back({stock_.x_of(i), stock_.y_of(j)});
        double farthest = 0.0;
        for (const auto& c : outer_) farthest = std::max(farthest, std::hypot(c[0], c[1]));
        for (int k = 0; k < kDirections; ++k) {
            const double angle = core::kPi * 2.0 * k / kDirections, c = std::cos(angle), s = std::sin(angle);
            for (const auto& cell : outer_)
                extents_[static_cast<std::size_t>(k)] = std::max(extents_[static_cast<std::size_t>(k)], cell[0] * c + cell[1] * s);
        }
        slack_ = farthest * core::kPi / kDirections + stock_.cell;
        farthest_ = farthest;
    }
    [[nodiscard]] double extent(double angle) const {
        const double turn = angle / (2.0 * core::kPi);
        return extents_[static_cast<std::size_t>((turn - std::floor(turn)) * kDirections + 0.5) % kDirections] + slack_;
    }

    Met cut_on_rotary_axis(const Move& move, const Tool& tool) {
        const Pose &a = move.from, &b = move.to;
        const double turn =
            core::rad_from_deg(std::abs(b.a - a.a)) * std::hypot(std::max(a.z, b.z), std::max(std::abs(a.y), std::abs(b.y)));
        const double way =
            std::hypot(b.x - a.x, b.y - a.y, b.z - a.z) + std::min(turn, core::rad_from_deg(std::abs(b.a - a.a)) * farthest_);
        const int steps = 1 + static_cast<int>(way / stock_.cell);
        Met met;
        for (int k = 0; k <= steps; ++k) {
            const Met here = cut_at(between(a, b, static_cast<double>(k) / steps), tool);
            met = {std::max(met.cutter, here.cutter), std::max(met.shank, here.shank), std::max(met.holder, here.holder)};
        }
        return met;
    }

    /// One pose in the body frame: a cell at height s above the tip and t beside the spindle's axis loses an interval about X.
    Met cut_at(const Pose& pose, const Tool& tool) {
        Met met;
        const double back = -setup_.rotary * core::rad_from_deg(pose.a), c = std::cos(back), n = std::sin(back);
        const double high = extent(back) - pose.z;  // of the stock above the tip
        if (high <= 0.0) return met;
        const std::array tip{pose.z * c + pose.y * n, pose.z * n - pose.y * c};
        const double reach = high > tool.stick_out ? tool.holder : std::max(tool.radius, tool.shank);
        const auto low_x = std::min(0.0, high * c) - reach, high_x = std::max(0.0, high * c) + reach;
        const auto low_y = std::min(0.0, high * n) - reach, high_y = std::max(0.0, high * n) + reach;
        const auto columns = stock_.span(tip[0] + low_x, tip[0] + high_x, stock_.x_low, stock_.columns);
        const auto rows = stock_.span(tip[1] + low_y, tip[1] + high_y, stock_.y_low, stock_.rows);
        for (std::size_t j = rows[0]; j < rows[1]; ++j) {
            const double y = stock_.y_of(j) - tip[1];
            const auto [first, last] = columns_beside(tip[0], {c, n}, y, reach);
            for (std::size_t i = std::max(columns[0], first); i < std::min(columns[1], last); ++i) {
                const std::size_t cell = j * stock_.columns + i;
                if (stock_.cells[cell].empty()) continue;
                const double x = stock_.x_of(i) - tip[0], s = x * c + y * n, t = std::abs(y * c - x * n);
                if (s < 0.0 || t > reach) continue;
                if (const double w = half_width(s <= tool.flute ? tool.radius_at(s) : 0.0, t); w > 0.0)
                    met.cutter = std::max(met.cutter, stock_.remove(cell, pose.x - w, pose.x + w));
                if (s > tool.flute) met.shank = std::max(met.shank, met_by(cell, pose.x, half_width(tool.shank, t)));
                if (s > tool.stick_out) met.holder = std::max(met.holder, met_by(cell, pose.x, half_width(tool.holder, t)));
            }
        }
        return met;
    }
    /// Columns of a row within `reach` of the spindle's axis and above the tip, and a cell more at each end, for rounding.
    /// @param axis cosine and sine of its direction @param y of the row, from the tip
    [[nodiscard]] std::array<std::size_t, 2> columns_beside(double tip_x, const std::array<double, 2>& axis, double y, double reach) const {
        constexpr double kLevel = 1e-9, kFar = 1e9;
        const auto [c, n] = axis;
        double low = -kFar, high = kFar;
        if (std::abs(n) > kLevel) low = (y * c - std::copysign(reach, n)) / n, high = (y * c + std::copysign(reach, n)) / n;
        if (c > kLevel) low = std::max(low, -y * n / c);
        if (c < -kLevel) high = std::min(high, -y * n / c);
        return stock_.span(tip_x + low - stock_.cell, tip_x + high + stock_.cell, stock_.x_low, stock_.columns);
    }
    static double half_width(double radius, double beside) { return beside < radius ? std::sqrt(radius * radius - beside * beside) : 0.0; }
    [[nodiscard]] double met_by(std::size_t cell, double x, double w) const {
        double length = 0.0;
        for (const auto& one : stock_.cells[cell]) length += std::max(0.0, std::min(one[1], x + w) - std::max(one[0], x - w));
        return length;
    }

    const Program& program_;
    Setup setup_;
    Stock stock_;
    std::vector<Contact> contacts_;
    std::vector<std::array<double, 2>> outer_;  ///< middles of the cells with material at the start
    std::vector<double> extents_;               ///< of the stock at the start, by direction
    double slack_ = 0.0, farthest_ = 0.0, minutes_ = 0.0, top_ = -1e9;
};

double outside(double value, const std::array<double, 2>& range) { return std::max({0.0, range[0] - value, value - range[1]}); }

/// A cylinder of the tool: everything above `z` within `radius` of the spindle's axis.
double overlap_of(double z, double radius, const Pose& pose, const Clamp& clamp) {
    if (!clamp.round) {
        const double away = std::hypot(outside(pose.x, clamp.x), outside(pose.y, clamp.y));
        return away < radius ? std::max(0.0, clamp.top - z) : 0.0;
    }
    if (outside(pose.x, clamp.x) >= radius) return 0.0;
    // The cylinder's nearest point to the rotary axis: beside it by what the radius does not bridge, and not below `z`.
    const double beside = std::max(0.0, std::abs(pose.y) - radius), above = std::max(0.0, z);
    return std::max(0.0, clamp.top - std::hypot(beside, above));
}

/// What a measured value is: most are lengths.
const char* unit_of(const std::string& rule) {
    constexpr std::array kCounted{"millsim.tool_change", "millsim.approach", "millsim.arc_mode", "millsim.tool_length", "millsim.spindle"};
    if (rule == "millsim.free") return "mm2";
    return std::find(kCounted.begin(), kCounted.end(), rule) != kCounted.end() ? "" : "mm";
}

constexpr double kThin_mm = 0.05;  // beyond a tab

std::size_t count_of(double low, double high, double cell) { return static_cast<std::size_t>(std::ceil((high - low) / cell)); }

}  // namespace

Result simulate(const Program& program, double cell_mm, const Stock* blank, double lift_mm) {
    Simulation simulation(program, cell_mm, blank, lift_mm);
    simulation.run();
    return std::move(simulation).done();
}

double overlap(const Tool& tool, const Pose& pose, const Clamp& clamp) {
    return std::max({overlap_of(pose.z, tool.radius, pose, clamp), overlap_of(pose.z + tool.flute, tool.shank, pose, clamp),
                     overlap_of(pose.z + tool.stick_out, tool.holder, pose, clamp)});
}

core::Findings contact_findings(const Result& result, const std::string& name) {
    core::Findings findings;
    for (const Contact& contact : result.contacts) {
        core::Finding f =
            core::error_finding(contact.rule, fmt::format("{}, first in line {}, {} moves", contact.what, contact.line, contact.moves),
                                contact.measured, core::Bound::kAtMost, 0.0, unit_of(contact.rule));
        f.where = name;
        f.suggestion = contact.rule == "millsim.holder" || contact.rule == "millsim.clamp"
                           ? fmt::format("machining.stick_out_mm longer by {:.1f}, or a smaller holder or chuck", contact.measured + 0.1)
                       : contact.rule == "millsim.free"  ? "machining.tabs, or machining.tab_width_mm smaller"
                       : contact.rule == "millsim.shank" ? fmt::format("machining.flute_length_mm longer by {:.1f}", contact.measured + 0.1)
                                                         : "report this program as an error of fusee";
        f.source = "docs/guides/milling.md: simulation of stock and holder";
        findings.push_back(std::move(f));
    }
    return findings;
}

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
