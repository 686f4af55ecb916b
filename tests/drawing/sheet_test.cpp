#include "fusee/drawing/sheet.h"

#include <gtest/gtest.h>

namespace fusee::drawing {
namespace {

TEST(Box, OfATextStandsOnItsBaseline) {
    const Box left = box_of({"12.5", {100.0, 50.0}}), middle = box_of({"12.5", {100.0, 50.0}, Align::kMiddle}),
              right = box_of({"12.5", {100.0, 50.0}, Align::kRight});
    const double width = 4 * 0.602 * Text::kBody;
    EXPECT_DOUBLE_EQ(left.low[0], 100.0);
    EXPECT_DOUBLE_EQ(left.high[0], 100.0 + width);
    EXPECT_DOUBLE_EQ(middle.low[0], 100.0 - 0.5 * width);
    EXPECT_DOUBLE_EQ(right.low[0], 100.0 - width);
    EXPECT_LT(left.low[1], 50.0 - 0.73 * Text::kBody);  // capitals are 0.73 of the size high
    EXPECT_GT(left.high[1], 50.0);
}

TEST(Box, OfAnUprightTextIsTheSameTurned) {
    const Box flat = box_of({"A-A", {0.0, 0.0}}), upright = box_of({"A-A", {0.0, 0.0}, Align::kLeft, Text::kBody, true});
    // Read from below to above: along is -y, and what was above is to the left.
    EXPECT_DOUBLE_EQ(upright.low[1], -flat.high[0]);
    EXPECT_DOUBLE_EQ(upright.high[1], -flat.low[0]);
    EXPECT_DOUBLE_EQ(upright.low[0], flat.low[1]);
    EXPECT_DOUBLE_EQ(upright.high[0], flat.high[1]);
}

TEST(Box, ALetterOfSeveralBytesCountsOnce) { EXPECT_DOUBLE_EQ(width_of("\u00d86", 1.0), width_of("D6", 1.0)); }

TEST(Box, IsMetByALineThroughItAndNotByOnePastIt) {
    const Box box{{0.0, 0.0}, {2.0, 1.0}};
    EXPECT_TRUE(box.meets({-1.0, 0.5}, {3.0, 0.5}));
    EXPECT_TRUE(box.meets({0.5, 0.4}, {0.6, 0.5}));  // wholly inside
    EXPECT_TRUE(box.meets({-1.0, -1.0}, {3.0, 2.0}));
    EXPECT_FALSE(box.meets({-1.0, 0.5}, {-0.1, 0.5}));  // ends before it
    EXPECT_FALSE(box.meets({-1.0, 0.0}, {1.0, 2.1}));   // passes a corner
    EXPECT_FALSE(box.meets({0.0, 1.5}, {2.0, 1.5}));
}

TEST(Sheet, WritesTheFirstPlaceThatIsClear) {
    Sheet sheet;
    sheet.texts.push_back({"taken", {50.0, 50.0}});
    sheet.strokes.push_back({Pen::kThin, {{40.0, 69.0}, {80.0, 69.0}}});
    sheet.write_clear({{"free", {52.0, 51.0}}, {"free", {50.0, 70.0}}, {"free", {50.0, 90.0}}});
    EXPECT_EQ(sheet.texts.back().at, (Point{50.0, 90.0}));
}

TEST(Svg, IsInMillimetresAndEscapes) {
    Sheet sheet;
    sheet.title = "a & b";
    sheet.texts.push_back({"1 < 2", {30.0, 40.0}, Align::kRight});
    const std::string text = svg(sheet);
    EXPECT_NE(text.find("width=\"420mm\" height=\"297mm\" viewBox=\"0 0 420 297\""), std::string::npos);
    EXPECT_NE(text.find("<title>a &amp; b</title>"), std::string::npos);
    EXPECT_NE(text.find("<text x=\"30\" y=\"40\" font-size=\"3.4\" text-anchor=\"end\">1 &lt; 2</text>"), std::string::npos);
}

}  // namespace
}  // namespace fusee::drawing
