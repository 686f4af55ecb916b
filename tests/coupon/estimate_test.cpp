#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fusee/coupon/calibration.h"

namespace fusee::coupon {
namespace {

TEST(Estimate, IntervalsAreStudents) {
    const Estimate four{1.0, 0.1, 4.0}, known{1.0, 0.1, std::numeric_limits<double>::infinity()};
    EXPECT_NEAR(four.interval().high, 1.0 + 0.1 * 2.776445, 1e-7) << "t of 4 degrees of freedom, 95 %";
    EXPECT_NEAR(known.interval().low, 1.0 - 0.1 * 1.959964, 1e-5) << "normal; Student's t of a million degrees is that to 3e-6";
    EXPECT_EQ((Estimate{1.0, 0.1, 4.9}.interval().high), four.interval().high) << "freedom is rounded down";
}

TEST(Estimate, ASumFollowsWelchAndSatterthwaite) {
    const Estimate a{2.0, 0.3, 4.0}, b{1.0, 0.4, 8.0};
    const Estimate both = sum({{1.0, a}, {-2.0, b}});
    EXPECT_DOUBLE_EQ(both.value, 0.0);
    EXPECT_NEAR(both.deviation, std::sqrt(0.09 + 0.64), 1e-15);
    EXPECT_NEAR(both.freedom, 0.73 * 0.73 / (0.0081 / 4.0 + 0.4096 / 8.0), 1e-12);
    EXPECT_TRUE(std::isinf(sum({{1.0, {2.0, 0.0, 3.0}}}).freedom)) << "an exact value has infinite freedom";
}

TEST(Estimate, ALineThroughThreePointsByHand) {
    const Line line = fit_line({{Item::kLengthX, 0.0, 0.0}, {Item::kLengthX, 1.0, 1.0}, {Item::kLengthX, 2.0, 3.0}}, 0.0);
    EXPECT_NEAR(line.slope.value, 1.5, 1e-14);
    EXPECT_NEAR(line.at_0.value, -1.0 / 6.0, 1e-14);
    EXPECT_NEAR(line.slope.deviation, std::sqrt(1.0 / 12.0), 1e-14) << "s^2 = 1/6 over a spread of 2";
    EXPECT_NEAR(line.at_0.deviation, std::sqrt(5.0 / 36.0), 1e-14);
    EXPECT_EQ(line.at_0.freedom, 1.0);
}

TEST(Estimate, AGaugeThatReadsTheSameEveryTimeIsNotExact) {
    const Line line = fit_line({{Item::kLengthX, 0.0, 0.0}, {Item::kLengthX, 1.0, 1.0}, {Item::kLengthX, 2.0, 2.0}}, 0.12);
    EXPECT_NEAR(line.slope.deviation, 0.12 / std::sqrt(12.0) / std::sqrt(2.0), 1e-15);
}

}  // namespace
}  // namespace fusee::coupon
