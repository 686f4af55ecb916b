#include "codesign/front.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fusee/core/error.h"

namespace fusee::search::codesign {
namespace {

/// Schaffer's problem: x^2 against (x - 2)^2, the rest of the numbers best at 0. The front is x in [0, 2].
std::array<double, 2> schaffer(std::span<const double> x) {
    double rest = 0.0;
    for (std::size_t i = 1; i < x.size(); ++i) rest += x[i] * x[i];
    return {x[0] * x[0] + rest, (x[0] - 2.0) * (x[0] - 2.0) + rest};
}

FrontOptions options() {
    FrontOptions o;
    o.bounds = {{-10.0, 10.0}, {-1.0, 1.0}, {-1.0, 1.0}};
    o.population = 40;
    o.generations = 120;
    return o;
}

TEST(Front, FindsAKnownFront) {
    const Front front = find_front(schaffer, options());
    EXPECT_GE(front.members.size(), 20u);
    EXPECT_EQ(front.generations, 120);
    EXPECT_FALSE(front.interrupted);
    for (const auto& x : front.members) {
        const auto f = schaffer(x);
        // sqrt f1 + sqrt f2 = 2 on the front; a random search comes near it: within half a percent of the box's width
        EXPECT_NEAR(std::sqrt(f[0]) + std::sqrt(f[1]), 2.0, 0.1);
    }
    for (std::size_t i = 1; i < front.members.size(); ++i) EXPECT_LE(schaffer(front.members[i - 1])[0], schaffer(front.members[i])[0]);
}

TEST(Front, SameSeedSameBitsOnAnyNumberOfThreads) {
    FrontOptions o = options();
    o.generations = 30;
    o.jobs = 1;
    const Front one = find_front(schaffer, o);
    for (const unsigned jobs : {2u, 5u}) {
        o.jobs = jobs;
        EXPECT_EQ(find_front(schaffer, o).members, one.members) << jobs;
    }
    o.seed = 2;
    EXPECT_NE(find_front(schaffer, o).members, one.members);
}

TEST(Front, GoodMembersGivenAreKeptOrBettered) {
    FrontOptions o = options();
    o.generations = 5;
    o.seeds = {{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}};  // both ends of the front: nothing dominates them
    const Front front = find_front(schaffer, o);
    EXPECT_EQ(schaffer(front.members.front())[0], 0.0);
    EXPECT_EQ(schaffer(front.members.back())[1], 0.0);
}

/// Two equal bounds fix a number: the front is that of the others.
TEST(Front, KeepsANumberWithEqualBounds) {
    FrontOptions o = options();
    o.bounds = {{-10.0, 10.0}, {0.5, 0.5}, {-1.0, 1.0}};
    o.seeds = {{1.0, 0.5, 0.0}};
    const Front front = find_front(schaffer, o);
    EXPECT_GE(front.members.size(), 20u);
    for (const auto& x : front.members) {
        ASSERT_EQ(x.size(), 3u);
        EXPECT_EQ(x[1], 0.5);
        const auto f = schaffer(x);
        EXPECT_NEAR(std::sqrt(f[0] - 0.25) + std::sqrt(f[1] - 0.25), 2.0, 0.2) << "Schaffer's front, 0.25 higher in both";
    }
    o.bounds = {{1.0, 1.0}, {0.5, 0.5}, {0.0, 0.0}};
    o.seeds.clear();
    EXPECT_EQ(find_front(schaffer, o).members, (std::vector<std::vector<double>>{{1.0, 0.5, 0.0}}));
}

TEST(Front, StopsWhenAsked) {
    FrontOptions o = options();
    o.stop = [] { return true; };
    const Front front = find_front(schaffer, o);
    EXPECT_TRUE(front.interrupted);
    EXPECT_LT(front.generations, o.generations);
    EXPECT_FALSE(front.members.empty());
}

TEST(Front, PopulationsThatCannotBePairedAreRefused) {
    FrontOptions o = options();
    o.population = 42;
    EXPECT_THROW((void)find_front(schaffer, o), core::InvalidInput);
}

}  // namespace
}  // namespace fusee::search::codesign
