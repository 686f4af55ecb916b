#include "fusee/solid/arrange.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace fusee::solid {
namespace {

// Known: two squares side by side need their widths and the spacing, and no more.
TEST(Arrange, FillsABedToTheLast) {
    const std::vector<Size2> two{{40.0, 40.0}, {40.0, 40.0}};
    const auto spots = arrange(two, {85.0, 40.0}, 5.0);
    ASSERT_TRUE(spots);
    EXPECT_EQ((*spots)[0].corner_mm, (Size2{0.0, 0.0}));
    EXPECT_EQ((*spots)[1].corner_mm, (Size2{45.0, 0.0}));
    EXPECT_FALSE(arrange(two, {84.9, 40.0}, 5.0));
    EXPECT_TRUE(arrange(two, {40.0, 85.0}, 5.0));
}

TEST(Arrange, TurnsWhatFitsTurnedOnly) {
    const auto spots = arrange({{60.0, 10.0}}, {20.0, 70.0}, 5.0);
    ASSERT_TRUE(spots);
    EXPECT_TRUE(spots->front().turned);
    EXPECT_FALSE(arrange({{60.0, 10.0}}, {70.0, 20.0}, 5.0)->front().turned) << "no turn without need";
}

// Four bars of 50 x 20 round a hole: a square of 75 holds them when two are turned.
TEST(Arrange, FindsAnOrderThatFits) {
    const auto spots = arrange({{50.0, 20.0}, {50.0, 20.0}, {50.0, 20.0}, {50.0, 20.0}}, {75.0, 75.0}, 5.0);
    ASSERT_TRUE(spots);
    EXPECT_FALSE(arrange({{50.0, 20.0}, {50.0, 20.0}, {50.0, 20.0}, {50.0, 20.0}}, {69.0, 69.0}, 5.0));
}

// Law: every arrangement lies on the bed with its spacing.
TEST(Arrange, KeepsApartWhateverItPlaces) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> side(5.0, 60.0);
    int placed = 0;
    for (int trial = 0; trial < 100; ++trial) {
        std::vector<Size2> sizes(4);
        for (Size2& size : sizes) size = {side(random), side(random)};
        const auto spots = arrange(sizes, {100.0, 90.0}, 5.0);
        if (!spots) continue;
        ++placed;
        for (std::size_t i = 0; i < 4; ++i) {
            const auto extent = [&](std::size_t k) { return (*spots)[k].turned ? Size2{sizes[k][1], sizes[k][0]} : sizes[k]; };
            EXPECT_LE((*spots)[i].corner_mm[0] + extent(i)[0], 100.0 + 1e-6);
            EXPECT_LE((*spots)[i].corner_mm[1] + extent(i)[1], 90.0 + 1e-6);
            for (std::size_t j = 0; j < i; ++j) {
                double gap = -1e9;
                for (std::size_t k = 0; k < 2; ++k) {
                    const double a = (*spots)[i].corner_mm[k], b = (*spots)[j].corner_mm[k];
                    gap = std::max({gap, b - a - extent(i)[k], a - b - extent(j)[k]});
                }
                EXPECT_GE(gap, 5.0 - 1e-6);
            }
        }
    }
    EXPECT_GT(placed, 30);
    EXPECT_LT(placed, 100) << "some have to be too large, or nothing is tested";
}

// Known: one square of 40 on a bed of 20 asks for twice the bed; two beside one another on 85 x 40 for just that.
TEST(LeastBed, IsTheFactorThatFits) {
    EXPECT_NEAR(least_bed({{40.0, 40.0}}, {20.0, 20.0}, 5.0), 2.0, 2e-3);
    EXPECT_NEAR(least_bed({{40.0, 40.0}, {40.0, 40.0}}, {42.5, 20.0}, 5.0), 2.0, 2e-3);
}

}  // namespace
}  // namespace fusee::solid
