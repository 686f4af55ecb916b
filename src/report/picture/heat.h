#pragma once
#include <array>
#include <string>

#include "picture/standalone.h"

/// The colours of a gap [sigma] in steps, from light to dark in one hue, as web/src/kit/heat.js has them.
namespace fusee::report {

inline constexpr std::array<double, 7> kGapBounds{1.0, 1.5, 2.0, 3.0, 5.0, 10.0, 20.0};
/// Level i holds bound i - 1 <= gap < bound i. ColorBrewer's YlOrBr in 8 classes, marked "colour-blind safe" (colorbrewer2.org).
inline constexpr std::array<const char*, 8> kGapFills{"#ffffe5", "#fff7bc", "#fee391", "#fec44f",
                                                      "#fe9929", "#ec7014", "#cc4c02", "#8c2d04"};

struct Box {
    double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
};
/// A cell with its figure in the middle, SVG; an empty frame with a dash for NaN.
[[nodiscard]] std::string heat_cell(const Box& box, double gap, const std::string& text);
/// Every level with its bounds.
[[nodiscard]] Figure gap_legend();

}  // namespace fusee::report
