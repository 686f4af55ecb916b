#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fusee/math/statistics.h"

// How much more than stated rows scatter.
namespace fusee::math {
namespace {

/// A sine of `per_turn` rows a turn with noise of this size, stated as 1.
Series sine(int rows, double per_turn, double noise) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal(0.0, noise);
    Series own;
    for (int i = 0; i < rows; ++i) own.values.push_back(100.0 * std::sin(6.2831853 * i / per_turn) + normal(random));
    own.sigma.assign(own.values.size(), 1.0);
    return own;
}

TEST(Scatter, IsThatOfTheNoiseAndNotOfTheCourse) {
    EXPECT_NEAR(scatter({sine(4000, 125.0, 3.0)}, 3), 3.0, 0.15);
    EXPECT_NEAR(least_scatter({sine(4000, 125.0, 3.0)}), 3.0, 0.3);
    EXPECT_GT(scatter({sine(4000, 12.0, 1.0)}, 3), 2.0);
    EXPECT_NEAR(least_scatter({sine(4000, 12.0, 1.0)}), 1.0, 0.1) << "coarse rows: the sixth differences lose the course";
}

TEST(Scatter, CountsEachRowInItsOwnSigma) {
    Series loud = sine(2000, 125.0, 6.0);
    for (double& sigma : loud.sigma) sigma = 2.0;
    EXPECT_NEAR(scatter({sine(2000, 125.0, 3.0), loud}, 3), 3.0, 0.2);
    EXPECT_NEAR(scatter({{sine(2000, 125.0, 3.0).values, {}}}, 3), 3.0, 0.2);
}

TEST(Scatter, AStepAndAFewRowsSayNothing) {
    Series stepped = sine(400, 125.0, 1.0);
    for (std::size_t i = 200; i < 400; ++i) stepped.values[i] += 500.0;
    EXPECT_NEAR(scatter({stepped}, 3), 1.0, 0.15);
    EXPECT_TRUE(std::isnan(least_scatter({sine(18, 125.0, 3.0)})));
    EXPECT_TRUE(std::isnan(scatter_of_repeats({{{1.0, 2.0, 3.0}, {1.0, 1.0, 1.0}}})));
}

TEST(Scatter, OfRepeatsIsThatWithinTheGroups) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal(0.0, 1.0);
    std::vector<Series> groups;
    for (int g = 0; g < 400; ++g) {
        const double sigma = 0.1 * (1 + g % 5);
        groups.push_back({{}, {sigma, sigma, sigma}});
        for (int i = 0; i < 3; ++i) groups.back().values.push_back(50.0 * g + 2.0 * sigma * normal(random));
    }
    EXPECT_NEAR(scatter_of_repeats(groups), 2.0, 0.2);
}

TEST(Scatter, RaisesWhatWasStatedOnlyWhereItIsClearlyMore) {
    EXPECT_EQ(noise_factor(3.0), 3.0);
    EXPECT_EQ(noise_factor(1.4), 1.0);
    EXPECT_EQ(noise_factor(0.2), 1.0);
    EXPECT_EQ(noise_factor(std::nan("")), 1.0);
}

}  // namespace
}  // namespace fusee::math
