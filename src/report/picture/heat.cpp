#include "picture/heat.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "data/figures.h"

namespace fusee::report {

namespace {

constexpr std::size_t kFirstDark = 6;  // white figures have more contrast from here on
constexpr double kBaseline = 4.0;      // from the middle of a line of text to its foot
constexpr double kKey = 76, kKeyHeight = 22;

}  // namespace

std::string heat_cell(const Box& box, double gap, const std::string& text) {
    const bool empty = !std::isfinite(gap);
    const auto level =
        empty ? 0 : static_cast<std::size_t>(std::upper_bound(kGapBounds.begin(), kGapBounds.end(), gap) - kGapBounds.begin());
    const std::string ink = empty ? "" : fmt::format(" style=\"fill:{}\"", level < kFirstDark ? "#15151a" : "#ffffff");
    return fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\" stroke=\"#8b8a85\" stroke-width=\".5\"/>"
        "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\"{}>{}</text>",
        coordinate(box.x), coordinate(box.y), coordinate(box.width), coordinate(box.height), empty ? "none" : kGapFills[level],
        coordinate(box.x + box.width / 2), coordinate(box.y + box.height / 2 + kBaseline), ink, escape(empty ? number(gap) : text));
}

Figure gap_legend() {
    Figure legend{"gap [sigma]", kKey * kGapFills.size(), kKeyHeight + 2, ""};
    for (std::size_t i = 0; i < kGapFills.size(); ++i) {
        const double low = i == 0 ? 0.0 : kGapBounds[i - 1];
        const std::string text = i == 0                      ? fmt::format("below {}", kGapBounds[0])
                                 : i + 1 == kGapFills.size() ? fmt::format("{} or more", low)
                                                             : fmt::format("{} to {}", low, kGapBounds[i]);
        legend.content += heat_cell({kKey * static_cast<double>(i), 1, kKey, kKeyHeight}, low, text);
    }
    return legend;
}

}  // namespace fusee::report
