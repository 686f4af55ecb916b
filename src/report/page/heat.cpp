#include "page/heat.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "page/html.h"

namespace fusee::report {

namespace {

constexpr std::size_t kFirstDark = 6;  // white figures have more contrast from here on: tests/report/heat_test.cpp
constexpr double kBaseline = 4.0;      // from the middle of a line of text to its foot
constexpr double kKey = 76, kKeyHeight = 22;

}  // namespace

std::size_t HeatScale::level(double value) const {
    return static_cast<std::size_t>(std::upper_bound(bounds.begin(), bounds.end(), value) - bounds.begin());
}
const char* HeatScale::ink(std::size_t level) { return level < kFirstDark ? "#15151a" : "#ffffff"; }

// Colours: ColorBrewer's YlOrBr and Blues in 8 classes, both marked "colour-blind safe" (colorbrewer2.org).
const HeatScale& gap_scale() {
    static const HeatScale scale{{1.0, 1.5, 2.0, 3.0, 5.0, 10.0, 20.0},
                                 {"#ffffe5", "#fff7bc", "#fee391", "#fec44f", "#fe9929", "#ec7014", "#cc4c02", "#8c2d04"},
                                 "gap [sigma]"};
    return scale;
}
const HeatScale& similarity_scale() {
    static const HeatScale scale{{10.0, 30.0, 50.0, 70.0, 80.0, 90.0, 95.0},
                                 {"#f7fbff", "#deebf7", "#c6dbef", "#9ecae1", "#6baed6", "#4292c6", "#2171b5", "#084594"},
                                 "similarity of signatures [%]"};
    return scale;
}

std::string heat_cell(const Box& box, double value, const std::string& text, const HeatScale& scale, bool marked) {
    const bool empty = !std::isfinite(value);
    const std::size_t level = empty ? 0 : scale.level(value);
    const std::string border = marked ? "stroke=\"#d02670\" stroke-width=\"2\"" : "stroke=\"#8b8a85\" stroke-width=\".5\"";
    std::string out =
        fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\" {}/>", coordinate(box.x), coordinate(box.y),
                    coordinate(box.width), coordinate(box.height), empty ? "none" : scale.fills[level], border);
    const std::string colour = empty ? "" : fmt::format(" style=\"fill:{}\"", HeatScale::ink(level));
    return out + fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\"{}>{}</text>", coordinate(box.x + box.width / 2),
                             coordinate(box.y + box.height / 2 + kBaseline), colour, escape(empty ? number(value) : text));
}

std::string heat_legend(const HeatScale& scale) {
    const double width = kKey * kHeatLevels;
    std::string out = fmt::format(
        "<figure class=\"plot\" style=\"max-width:{}px\"><figcaption>{}</figcaption><svg viewBox=\"0 0 {} {}\" role=\"img\" "
        "aria-label=\"scale\">",
        width + 26, escape(scale.name), width, kKeyHeight + 2);
    for (std::size_t i = 0; i < kHeatLevels; ++i) {
        const double low = i == 0 ? 0.0 : scale.bounds[i - 1];
        const std::string text = i == 0                 ? fmt::format("below {}", scale.bounds[0])
                                 : i + 1 == kHeatLevels ? fmt::format("{} or more", low)
                                                        : fmt::format("{} to {}", low, scale.bounds[i]);
        out += heat_cell({kKey * static_cast<double>(i), 1, kKey, kKeyHeight}, low, text, scale);
    }
    return out + "</svg></figure>\n";
}

}  // namespace fusee::report
