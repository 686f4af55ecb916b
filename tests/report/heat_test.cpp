#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "fusee/diagnosis/diagnosis.h"
#include "picture/plot.h"
#include "rig/gap_map.h"

namespace fusee::report {
namespace {

/// Relative luminance of "#rrggbb" (WCAG 2.1).
double luminance(const std::string& colour) {
    const auto channel = [&](std::size_t at) {
        const double c = std::stoi(colour.substr(at, 2), nullptr, 16) / 255.0;
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * channel(1) + 0.7152 * channel(3) + 0.0722 * channel(5);
}
double contrast(const std::string& a, const std::string& b) {
    const auto [dark, light] = std::minmax({luminance(a), luminance(b)});
    return (light + 0.05) / (dark + 0.05);
}

std::string ink_of(const std::string& cell) { return cell.substr(cell.find("style=\"fill:") + 12, 7); }

TEST(HeatScale, GetsDarkerWithEveryLevelSoThatGreyPrintKeepsTheOrder) {
    EXPECT_TRUE(std::is_sorted(kGapBounds.begin(), kGapBounds.end()));
    for (std::size_t i = 1; i < kGapFills.size(); ++i) EXPECT_LT(luminance(kGapFills[i]), 0.95 * luminance(kGapFills[i - 1])) << i;
}

TEST(HeatCell, ShowsItsFigureOnTheColourOfItsLevel) {
    const std::string cell = heat_cell({10, 20, 40, 30}, 7.9, "7.9");
    EXPECT_NE(cell.find("<rect x=\"10\" y=\"20\" width=\"40\" height=\"30\" fill=\"#ec7014\""), std::string::npos) << cell;
    EXPECT_NE(cell.find("x=\"30\" y=\"39\""), std::string::npos) << cell;
    EXPECT_NE(cell.find(">7.9</text>"), std::string::npos);
    for (const double gap : {0.0, 0.999, 1.0, 2.5, 19.9, 20.0, 1e300}) {
        const auto level =
            static_cast<std::size_t>(std::count_if(kGapBounds.begin(), kGapBounds.end(), [=](double b) { return b <= gap; }));
        const std::string at = heat_cell({}, gap, "x");
        EXPECT_NE(at.find(kGapFills[level]), std::string::npos) << gap;
        EXPECT_GE(contrast(kGapFills[level], ink_of(at)), 4.5) << "WCAG 2.1, level AA";
    }
}

TEST(HeatCell, IsEmptyWithADashWhereNothingIsKnown) {
    for (const double value : {diagnosis::kNoFigure, std::numeric_limits<double>::infinity()}) {
        const std::string cell = heat_cell({0, 0, 10, 10}, value, "nan");
        EXPECT_NE(cell.find("fill=\"none\""), std::string::npos);
        EXPECT_NE(cell.find(">\u2013</text>"), std::string::npos);
        EXPECT_EQ(cell.find("nan"), std::string::npos);
    }
}

TEST(HeatLegend, StatesEveryBound) {
    const Figure legend = gap_legend();
    EXPECT_EQ(legend.caption, "gap [sigma]");
    for (const char* text : {">below 1<", ">1 to 1.5<", ">5 to 10<", ">20 or more<"})
        EXPECT_NE(legend.content.find(text), std::string::npos) << text;
    for (const char* fill : kGapFills) EXPECT_NE(legend.content.find(fill), std::string::npos) << fill;
}

std::size_t count_of(const std::vector<Figure>& figures, const std::string& text) {
    std::size_t count = 0;
    for (const Figure& figure : figures)
        for (std::size_t at = figure.content.find(text); at != std::string::npos; at = figure.content.find(text, at + 1)) ++count;
    return count;
}

TEST(GapMap, IsAStripForEachExperimentBeforeAndAfter) {
    const auto map = gap_map_figures(
        {{"dead_band", "cocontraction_Nm", {0.3, 0.5}, 2.4, 1.1, 5}, {"dead_band", "cocontraction_Nm", {0.1, 0.3}, 27.0, 0.8, 5}});
    for (const char* cell : {"fill=\"#8c2d04\"", "fill=\"#fec44f\"", "fill=\"#fff7bc\"", "fill=\"#ffffe5\""})
        EXPECT_EQ(count_of(map, cell), 2u) << cell << ": one cell, one key of the legend";
    EXPECT_LT(map[0].content.find(">27<"), map[0].content.find(">2.4<")) << "by rising range";
    EXPECT_EQ(count_of(map, ">0.3</text>"), 2u) << "an edge that two cells share is shown once in each map";
    EXPECT_EQ(count_of(map, ">dead-band</text>"), 2u);
    EXPECT_TRUE(gap_map_figures({}).empty());
}

TEST(GapMap, FoldsLongStripsAndNamesRangesThatDoNotTouch) {
    std::vector<diagnosis::GapCell> map;
    for (int i = 0; i < 30; ++i) map.push_back({"log", "t_s", {i + 0.0, i + 1.0}, 1.0, 1.0, 9});
    EXPECT_EQ(count_of(gap_map_figures(map), ">time log</text>"), 2u * 4u);
    map = {{"dead_band", "cocontraction_Nm", {0.1, 0.1}, 1, 1, 3}, {"dead_band", "cocontraction_Nm", {0.5, 0.8}, 1, 1, 3}};
    EXPECT_EQ(count_of(gap_map_figures(map), ">0.5\u20130.8</text>"), 2u);
}

}  // namespace
}  // namespace fusee::report
