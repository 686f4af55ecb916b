#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fusee/inference/constants.h"
#include "fusee/inference/search.h"

namespace fusee::inference {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

TEST(Probabilities, AreTheShareOfEachScore) {
    const std::vector<double> p = probabilities(std::vector<double>{-1000.0, -1000.0 + std::log(3.0), -kNone});
    EXPECT_NEAR(p[0], 0.25, 1e-12);
    EXPECT_NEAR(p[1], 0.75, 1e-12);
    EXPECT_EQ(p[2], 0.0);
}

TEST(Probabilities, OfASureAnswerHaveNoRival) {
    EXPECT_TRUE(rivalled(kSure - 0.01, kRival));
    EXPECT_FALSE(rivalled(kSure, 1.0 - kSure));
    EXPECT_FALSE(rivalled(kSure - 0.01, kRival - 0.01));  // many others, none worth an experiment
    EXPECT_LT(kUnsureShare, kSure);                       // what the rows do not tell apart is never certain
    EXPECT_GE(1.0 - kUnsureShare, kRival);
}

}  // namespace
}  // namespace fusee::inference
