#include "data/figures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace fusee::report {
namespace {

TEST(Figures, NumbersHaveAFixedNumberOfDigits) {
    EXPECT_EQ(number(std::numeric_limits<double>::quiet_NaN()), "\u2013");
    EXPECT_EQ(number(-INFINITY), "\u2013");
    EXPECT_EQ(number(1234.5678), "1235");
    EXPECT_EQ(number(40763.2), "40763");
    EXPECT_EQ(number(0.000123456), "0.0001235");
    EXPECT_EQ(span({NAN, 1.0}), "\u2013");
    EXPECT_EQ(span({0.12, 0.5}), "0.12 to 0.5");
    EXPECT_EQ(change(9.1, NAN), "9.1 \u2192 \u2013");
    EXPECT_EQ(percent(0.623), "62 %");
    EXPECT_EQ(percent(NAN), "\u2013");
    EXPECT_EQ(coordinate(-0.0001), "0");
    EXPECT_EQ(coordinate(1.25), "1.25");
}

}  // namespace
}  // namespace fusee::report
