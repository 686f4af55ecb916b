#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "design/cam_drawing.h"
#include "design/markers.h"
#include "report/fixture.h"

namespace fusee::report {
namespace {

double attribute(const std::string& svg, const std::string& pattern) {
    std::smatch match;
    EXPECT_TRUE(std::regex_search(svg, match, std::regex(pattern))) << pattern;
    return match.empty() ? 0.0 : std::stod(match[1]);
}

/// Width of the path with this class, in the drawing's units.
double path_width(const std::string& svg, const std::string& css) {
    std::smatch match;
    EXPECT_TRUE(std::regex_search(svg, match, std::regex("class=\"" + css + "\" d=\"([^\"]*)\""))) << css;
    const std::string data = match[1];
    double low = 1e9, high = -1e9;
    const std::regex point("[ML](-?[0-9.]+) ");
    for (auto it = std::sregex_iterator(data.begin(), data.end(), point); it != std::sregex_iterator(); ++it) {
        low = std::min(low, std::stod((*it)[1]));
        high = std::max(high, std::stod((*it)[1]));
    }
    return high - low;
}

TEST(CamDrawing, ADiscOfRadius10mmIsDrawn20mmWide) {
    const std::string svg = cam_svg(disc(cam::PartKind::kSeries), {});
    const double mm_per_unit = attribute(svg, "width=\"([0-9.]+)mm\"") / attribute(svg, "viewBox=\"[-0-9.]+ [-0-9.]+ ([0-9.]+) ");
    EXPECT_DOUBLE_EQ(mm_per_unit, 1.0);
    // Coordinates have three decimals, so two ends are off by at most 1e-3 together.
    EXPECT_NEAR(path_width(svg, "pitch") * mm_per_unit, 20.0, 1e-3);
    EXPECT_NEAR(path_width(svg, "body") * mm_per_unit, 20.0, 1e-3);
    EXPECT_NEAR(path_width(svg, "floor") * mm_per_unit, 19.0, 1e-3);  // half a cable of 1 mm on each side
}

TEST(CamDrawing, TheScaleBarHasTheStatedLength) {
    const std::string svg = cam_svg(disc(cam::PartKind::kSeries), {});
    EXPECT_EQ(attribute(svg, "class=\"scale\"><path d=\"M[-0-9.]+ [-0-9.]+v[-0-9.]+h([0-9.]+)v"), attribute(svg, ">([0-9.]+) mm</text>"));
}

TEST(CamDrawing, TheWorkingArcAndTheCableStandWhereTheyTouch) {
    const std::string svg = cam_svg(disc(cam::PartKind::kSeries), {});
    // The contact at psi = 0.5 on the disc; y points down in SVG.
    EXPECT_NEAR(attribute(svg, "class=\"working\" d=\"M([-0-9.]+) "), 10.0 * std::cos(0.5), 1e-3);
    EXPECT_NEAR(attribute(svg, "class=\"cable\"><path d=\"M[-0-9.]+ ([-0-9.]+)L"), -10.0 * std::sin(0.5), 1e-3);
}

TEST(CamDrawing, EveryMarkerIsDrawnWithItsNumberAndPlace) {
    const std::string svg = cam_svg(disc(cam::PartKind::kSeries), {{7, core::Severity::kError, 3.0, 4.0, "a<b"}});
    EXPECT_NE(svg.find("aria-label=\"a&lt;b\"><title>a&lt;b</title><path class=\"leader\" d=\"M3 -4L"), std::string::npos);
    EXPECT_NE(svg.find(">7</text>"), std::string::npos);
}

TEST(Markers, AreMovedApartAndKeepTheirOrder) {
    const std::vector<double> moved = spread_angles({0.1, 0.0, 0.1, 3.0, -3.1}, 0.3);
    std::vector<double> sorted = moved;
    std::sort(sorted.begin(), sorted.end());
    // The passes halve what is lacking; 1e-6 rad is far below what a drawing shows.
    for (std::size_t i = 1; i < sorted.size(); ++i) EXPECT_GE(sorted[i] - sorted[i - 1], 0.3 - 1e-6);
    EXPECT_GE(sorted.front() + 2.0 * core::kPi - sorted.back(), 0.3 - 1e-6);
    EXPECT_LT(moved[1], moved[0]);
}

}  // namespace
}  // namespace fusee::report
