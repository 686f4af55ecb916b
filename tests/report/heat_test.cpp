#include "page/heat.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "fusee/diagnosis/diagnosis.h"

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

TEST(HeatScale, LevelsBeginAtTheirBounds) {
    const HeatScale& gap = gap_scale();
    EXPECT_EQ(gap.level(0.0), 0u);
    EXPECT_EQ(gap.level(0.999), 0u);
    EXPECT_EQ(gap.level(1.0), 1u);
    EXPECT_EQ(gap.level(2.5), 3u);
    EXPECT_EQ(gap.level(19.9), 6u);
    EXPECT_EQ(gap.level(20.0), 7u);
    EXPECT_EQ(gap.level(1e300), 7u);
    EXPECT_EQ(similarity_scale().level(94.9), 6u);
    EXPECT_EQ(similarity_scale().level(100.0), 7u);
}

TEST(HeatScale, GetsDarkerWithEveryLevelSoThatGreyPrintKeepsTheOrder) {
    for (const HeatScale* scale : {&gap_scale(), &similarity_scale()}) {
        EXPECT_TRUE(std::is_sorted(scale->bounds.begin(), scale->bounds.end()));
        for (std::size_t i = 1; i < kHeatLevels; ++i)
            EXPECT_LT(luminance(scale->fills[i]), 0.95 * luminance(scale->fills[i - 1])) << scale->name << " " << i;
    }
}

TEST(HeatScale, FiguresCanBeReadOnEveryLevel) {
    for (const HeatScale* scale : {&gap_scale(), &similarity_scale()})
        for (std::size_t i = 0; i < kHeatLevels; ++i)  // 4.5: WCAG 2.1, level AA
            EXPECT_GE(contrast(scale->fills[i], HeatScale::ink(i)), 4.5) << scale->name << " " << i;
}

TEST(HeatCell, ShowsItsFigureOnTheColourOfItsLevel) {
    const std::string cell = heat_cell({10, 20, 40, 30}, 7.9, "7.9", gap_scale());
    EXPECT_NE(cell.find("<rect x=\"10\" y=\"20\" width=\"40\" height=\"30\" fill=\"#ec7014\""), std::string::npos) << cell;
    EXPECT_NE(cell.find("x=\"30\" y=\"39\""), std::string::npos) << cell;
    EXPECT_NE(cell.find(">7.9</text>"), std::string::npos);
    EXPECT_NE(heat_cell({}, 15.0, "15", gap_scale()).find("fill:#ffffff"), std::string::npos);
    EXPECT_NE(cell, heat_cell({10, 20, 40, 30}, 7.9, "7.9", gap_scale(), true)) << "a marked cell has another border";
}

TEST(HeatCell, IsEmptyWithADashWhereNothingIsKnown) {
    for (const double value : {diagnosis::kNoFigure, std::numeric_limits<double>::infinity()}) {
        const std::string cell = heat_cell({0, 0, 10, 10}, value, "nan", gap_scale());
        EXPECT_NE(cell.find("fill=\"none\""), std::string::npos);
        EXPECT_NE(cell.find(">\u2013</text>"), std::string::npos);
        EXPECT_EQ(cell.find("nan"), std::string::npos);
    }
}

TEST(HeatLegend, StatesEveryBound) {
    const std::string legend = heat_legend(gap_scale());
    for (const char* text : {"gap [sigma]", ">below 1<", ">1 to 1.5<", ">5 to 10<", ">20 or more<"})
        EXPECT_NE(legend.find(text), std::string::npos) << text;
    for (const char* fill : gap_scale().fills) EXPECT_NE(legend.find(fill), std::string::npos) << fill;
}

}  // namespace
}  // namespace fusee::report
