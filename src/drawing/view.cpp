#include "view.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

namespace fusee::drawing {

namespace {

constexpr std::array kScales{100.0, 50.0, 20.0, 10.0, 5.0, 2.0, 1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01};

}  // namespace

Line View::at(const Line& line) const {
    Line out;
    for (const Point& p : line) out.push_back(at(p));
    return out;
}

std::vector<Line> View::at(const std::vector<Line>& lines) const {
    std::vector<Line> out;
    for (const Line& line : lines) out.push_back(at(line));
    return out;
}

double largest_scale(const std::function<bool(double)>& fits) {
    const auto found = std::find_if(kScales.begin(), kScales.end(), fits);
    return found == kScales.end() ? kScales.back() : *found;
}

std::string scale_text(double scale) { return scale >= 1.0 ? fmt::format("{:g}:1", scale) : fmt::format("1:{:g}", 1.0 / scale); }

Box extent(const std::vector<Line>& lines) {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    Box box{{kFar, kFar}, {-kFar, -kFar}};
    for (const Line& line : lines)
        for (const Point& p : line)
            for (std::size_t i = 0; i < 2; ++i) {
                box.low[i] = std::min(box.low[i], p[i]);
                box.high[i] = std::max(box.high[i], p[i]);
            }
    return box;
}

std::string decimals(double value, int digits) {
    std::string text = fmt::format("{:.{}f}", value, digits);
    if (text.find('.') != std::string::npos) text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text.pop_back();
    return text == "-0" ? "0" : text;
}

}  // namespace fusee::drawing
