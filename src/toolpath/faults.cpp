#include <fmt/format.h>

#include <cmath>

#include "fusee/toolpath/read_back.h"
#include "words.h"

namespace fusee::toolpath {

namespace {

constexpr double kProbe_mm = 0.1;   // step along a rapid: a thicker stock is never missed
constexpr double kTouch_mm = 1e-4;  // the last printed digit of the interpreter: a rapid may run along the top

struct Stock {
    bool round = false;
    double x_low = 0.0, x_high = 0.0, y_low = 0.0, y_high = 0.0, z_low = 0.0, z_high = 0.0, radius = 0.0;
    /// Is the cutter's tip inside its outline and below its top? Also below the stock: a rapid could only get there through it.
    [[nodiscard]] bool holds(const Pose& p) const {
        if (p.x < x_low || p.x > x_high) return false;
        if (round) return std::abs(p.y) < radius && p.z < std::sqrt(radius * radius - p.y * p.y) - kTouch_mm;
        return p.y > y_low && p.y < y_high && p.z < z_high - kTouch_mm;
    }
};

std::optional<Stock> stock_of(const Interpreted& program) {
    const auto number = [&](const std::vector<std::string>& words, std::size_t i) { return number_in(program, words, i); };
    if (const auto box = find_words(program, "stock", 8); !box.empty() && box[1] == "box")
        return Stock{false, number(box, 2), number(box, 3), number(box, 4), number(box, 5), number(box, 6), number(box, 7), 0.0};
    if (const auto round = find_words(program, "stock", 5); !round.empty() && round[1] == "round")
        return Stock{true, number(round, 3), number(round, 4), 0.0, 0.0, 0.0, 0.0, number(round, 2)};
    return std::nullopt;
}

bool passes_through(const Stock& stock, const Move& move) {
    const double way = std::hypot(move.to.x - move.from.x, move.to.y - move.from.y, move.to.z - move.from.z);
    const int probes = 1 + static_cast<int>(way / kProbe_mm);
    for (int i = 0; i <= probes; ++i)
        if (stock.holds(between(move.from, move.to, static_cast<double>(i) / probes))) return true;
    return false;
}

}  // namespace

std::vector<std::string> faults(const Interpreted& program) {
    std::vector<std::string> found;
    const auto stock = stock_of(program);
    if (!stock) found.emplace_back("no comment states the stock");
    if (program.moves.empty()) found.emplace_back("nothing moves");
    for (const Move& move : program.moves) {
        if (!move.rapid && !(move.feed > 0.0)) found.push_back(fmt::format("row {}: a feed of {} mm/min", move.row, move.feed));
        if (move.rapid && stock && passes_through(*stock, move))
            found.push_back(fmt::format("row {}: a rapid to X{:.3f} Y{:.3f} Z{:.3f} passes through the stock", move.row, move.to.x,
                                        move.to.y, move.to.z));
    }
    return found;
}

}  // namespace fusee::toolpath
