#include "fusee/math/roots.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fusee::math {
namespace {

TEST(BracketedRoot, FindsKnownRootsToTheLastDigits) {
    const auto root2 = bracketed_root([](double x) { return x * x - 2.0; }, 0.0, 2.0);
    ASSERT_TRUE(root2);
    EXPECT_NEAR(*root2, std::sqrt(2.0), 4e-16);  // two units in the last place of sqrt(2)
    const auto falling = bracketed_root([](double x) { return 1.0 - std::exp(x); }, -3.0, 1.0);
    ASSERT_TRUE(falling);
    EXPECT_NEAR(*falling, 0.0, 1e-15);
}

TEST(BracketedRoot, TakesAnEndThatIsTheRootAndAHugeFarEnd) {
    EXPECT_EQ(bracketed_root([](double x) { return x; }, 0.0, 1.0), 0.0);
    EXPECT_EQ(bracketed_root([](double x) { return x; }, -1.0, 0.0), 0.0);
    const auto steep = bracketed_root([](double x) { return x > 50.0 ? 1e300 : x - 0.125; }, 0.0, 100.0);
    ASSERT_TRUE(steep);
    EXPECT_NEAR(*steep, 0.125, 1e-15);
}

TEST(BracketedRoot, RefusesWithoutASignChange) {
    EXPECT_FALSE(bracketed_root([](double x) { return x + 1.0; }, 0.0, 1.0));
    EXPECT_FALSE(bracketed_root([](double) { return std::nan(""); }, 0.0, 1.0));
    EXPECT_FALSE(bracketed_root([](double x) { return x; }, 1.0, -1.0));
}

TEST(RisingRoot, FindsKnownRootsFromAnyStart) {
    for (const double start : {-5.0, 0.0, 1e-3, 1.4, 9.0, 99.0}) {
        EXPECT_NEAR(rising_root([](double x) { return Tangent{x * x - 2.0, 2.0 * x}; }, 0.0, 10.0, start), std::sqrt(2.0), 4e-16);
        // The slope says too little far out and too much near: Newton alone would leave the bracket.
        EXPECT_NEAR(rising_root(
                        [](double x) {
                            return Tangent{std::atan(x - 3.0), 1.0 / (1.0 + (x - 3.0) * (x - 3.0))};
                        },
                        -10.0, 10.0, start),
                    3.0, 1e-15);
    }
}

TEST(RisingRoot, GivesTheEndBeyondWhichTheRootLies) {
    const auto line = [](double x) { return Tangent{x - 5.0, 1.0}; };
    EXPECT_NEAR(rising_root(line, 0.0, 2.0, 1.0), 2.0, 1e-15);
    EXPECT_NEAR(rising_root(line, 6.0, 8.0, 7.0), 6.0, 1e-15);
}

}  // namespace
}  // namespace fusee::math
