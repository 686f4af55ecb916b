#include <algorithm>
#include <limits>

#include "page/svg_plot.h"
#include "page_structure.h"

namespace fusee::report {
namespace {

TEST(Plot, TicksAreRoundAndInside) {
    EXPECT_EQ(round_ticks({0.0, 10.0}, 5), (std::vector<double>{0.0, 2.0, 4.0, 6.0, 8.0, 10.0}));
    EXPECT_EQ(round_ticks({0.9, 3.1}, 2), (std::vector<double>{2.0}));
    EXPECT_EQ(round_ticks({-1.0, 1.0}, 2), (std::vector<double>{-1.0, 0.0, 1.0}));
}

TEST(Plot, LongTickLabelsStandBesideTheAxisName) {
    // 22 units for the name, "-1.5e-06" with 6.6 a letter, 8 to the axis.
    const std::string small = Plot("t", "x", "y").curve("a", {0, 1}, {-2e-6, -1e-6}, "se").from_zero().svg();
    EXPECT_NE(small.find(">-1.5e-06</text>"), std::string::npos);
    EXPECT_NE(small.find("d=\"M82.8 "), std::string::npos);
    EXPECT_NE(small.find(">0</text>"), std::string::npos) << "an axis of values below zero ends at zero";
    EXPECT_NE(Plot("t", "x", "y").curve("a", {0, 1}, {0, 1}, "se").svg().find("d=\"M58 "), std::string::npos);
}

TEST(Plot, ANotANumberLeavesAGap) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::string svg = Plot("t", "x", "y").curve("a", {0, 1, 2, 3, 4}, {0, 1, nan, 3, 4}, "se").svg();
    const auto at = svg.find("class=\"curve se\" d=\"");
    ASSERT_NE(at, std::string::npos);
    const std::string data = svg.substr(at, svg.find("\"/", at) - at);
    EXPECT_EQ(std::count(data.begin(), data.end(), 'M'), 2);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(Plot, NothingToShowIsStillAPicture) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(Plot("t", "x", "y").curve("a", {}, {}, "se").svg().find("nan"), std::string::npos);
    EXPECT_EQ(Plot("t", "x", "y").curve("a", {1, 2}, {nan, nan}, "se").svg().find("nan"), std::string::npos);
    EXPECT_EQ(Plot("t", "x", "y").curve("a", {1, 2}, {3, 3}, "se").svg().find("inf"), std::string::npos);
}

TEST(Plot, DotsCarryBarsWhereADeviationIsKnown) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::string svg = Plot("t", "x", "y").points("p", {0, 1, 2, nan}, {1, 2, 3, 4}, "se", {0.5, nan, 1.0, 1.0}).svg();
    EXPECT_EQ(occurrences(svg, "<circle"), 3u);
    const auto at = svg.find("bar\" d=\"");
    ASSERT_NE(at, std::string::npos);
    const std::string bars = svg.substr(at, svg.find("\"/", at) - at);
    EXPECT_EQ(std::count(bars.begin(), bars.end(), 'V'), 2);
    // The bar of the last dot reaches to y = 4: the axis does too.
    EXPECT_NE(svg.find(">4</text>"), std::string::npos);
}

TEST(Plot, ALegendThatIsTooLongTakesMoreLines) {
    Plot plot("t", "x", "y");
    for (const char* name : {"the first of these curves", "the second of these curves", "the third of these curves"})
        plot.curve(name, {0, 1}, {0, 1}, "se");
    const std::string svg = plot.svg();
    EXPECT_NE(svg.find("translate(58 20)"), std::string::npos);
    EXPECT_NE(svg.find("translate(58 38)"), std::string::npos);
}

TEST(Plot, ABandIsOneClosedPath) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::string svg = Plot("t", "x", "y").band("b", {0, 1, 2}, {0, 0, nan}, {1, 2, 3}, "sum").svg();
    const auto at = svg.find("class=\"band sum\" d=\"");
    ASSERT_NE(at, std::string::npos);
    const std::string path = svg.substr(at, svg.find("\">", at + 20) - at);
    EXPECT_EQ(std::count(path.begin(), path.end(), 'L'), 3);
    EXPECT_EQ(path.back(), 'Z');
}

TEST(Plot, EscapesItsTexts) {
    const std::string svg = Plot("a<b", "x&y", "\"y\"").shade({0, 1}, "<s>").mark(1, "<m>").curve("<c>", {0, 2}, {0, 1}, "se").svg();
    for (const char* raw : {"a<b", "x&y", "<s>", "<m>", "<c>"}) EXPECT_EQ(svg.find(raw), std::string::npos) << raw;
}

}  // namespace
}  // namespace fusee::report
