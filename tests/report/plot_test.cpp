#include "picture/plot.h"

#include <algorithm>
#include <limits>

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
    const std::string small = Plot("t", "x", "y").curve("a", {0, 1}, {-2e-6, -1e-6}, "se").from_zero().figure().content;
    EXPECT_NE(small.find(">-1.5e-06</text>"), std::string::npos);
    EXPECT_NE(small.find("d=\"M82.8 "), std::string::npos);
    EXPECT_NE(small.find(">0</text>"), std::string::npos) << "an axis of values below zero ends at zero";
    EXPECT_NE(Plot("t", "x", "y").curve("a", {0, 1}, {0, 1}, "se").figure().content.find("d=\"M58 "), std::string::npos);
}

TEST(Plot, ANotANumberLeavesAGap) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::string svg = Plot("t", "x", "y").curve("a", {0, 1, 2, 3, 4}, {0, 1, nan, 3, 4}, "se").figure().content;
    const auto at = svg.find("class=\"curve se\" d=\"");
    ASSERT_NE(at, std::string::npos);
    const std::string data = svg.substr(at, svg.find("\"/", at) - at);
    EXPECT_EQ(std::count(data.begin(), data.end(), 'M'), 2);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(Plot, NothingToShowIsStillAPicture) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(Plot("t", "x", "y").curve("a", {}, {}, "se").figure().content.find("nan"), std::string::npos);
    EXPECT_EQ(Plot("t", "x", "y").curve("a", {1, 2}, {nan, nan}, "se").figure().content.find("nan"), std::string::npos);
    EXPECT_EQ(Plot("t", "x", "y").curve("a", {1, 2}, {3, 3}, "se").figure().content.find("inf"), std::string::npos);
}

TEST(Plot, ALegendThatIsTooLongTakesMoreLines) {
    Plot plot("t", "x", "y");
    for (const char* name : {"the first of these curves", "the second of these curves", "the third of these curves"})
        plot.curve(name, {0, 1}, {0, 1}, "se");
    const std::string svg = plot.figure().content;
    EXPECT_NE(svg.find("translate(58 20)"), std::string::npos);
    EXPECT_NE(svg.find("translate(58 38)"), std::string::npos);
}

TEST(Plot, EscapesItsTexts) {
    const std::string svg = Plot("a<b", "x&y", "\"y\"").shade({0, 1}, "<s>").curve("<c>", {0, 2}, {0, 1}, "se").figure().content;
    for (const char* raw : {"x&y", "<s>", "<c>"}) EXPECT_EQ(svg.find(raw), std::string::npos) << raw;
}

}  // namespace
}  // namespace fusee::report
