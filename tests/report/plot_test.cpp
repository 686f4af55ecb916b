#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "report/svg_plot.h"

namespace fusee::report {
namespace {

TEST(Plot, TicksAreRoundAndInside) {
    EXPECT_EQ(round_ticks({0.0, 10.0}, 5), (std::vector<double>{0.0, 2.0, 4.0, 6.0, 8.0, 10.0}));
    EXPECT_EQ(round_ticks({0.9, 3.1}, 2), (std::vector<double>{2.0}));
    EXPECT_EQ(round_ticks({-1.0, 1.0}, 2), (std::vector<double>{-1.0, 0.0, 1.0}));
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

TEST(Plot, EscapesItsTexts) {
    const std::string svg = Plot("a<b", "x&y", "\"y\"").shade({0, 1}, "<s>").mark(1, "<m>").curve("<c>", {0, 2}, {0, 1}, "se").svg();
    for (const char* raw : {"a<b", "x&y", "<s>", "<m>", "<c>"}) EXPECT_EQ(svg.find(raw), std::string::npos) << raw;
}

}  // namespace
}  // namespace fusee::report
