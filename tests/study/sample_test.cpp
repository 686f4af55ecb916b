#include "sample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace fusee::study {
namespace {

TEST(Sample, SobolBeginsWithTheKnownPoints) {
    const auto sample = make_sample(Method::kSobol, 3, 8, 1);
    const std::vector<std::vector<double>> known{{0.5, 0.5, 0.5}, {0.75, 0.25, 0.25}, {0.25, 0.75, 0.75}, {0.375, 0.375, 0.625}};
    for (std::size_t i = 0; i < known.size(); ++i) EXPECT_EQ(sample->point(i), known[i]) << i;
}

TEST(Sample, LatinHypercubeTakesEachIntervalOnceForEachKey) {
    constexpr std::size_t kCount = 50;
    const auto sample = make_sample(Method::kLatinHypercube, 4, kCount, 7);
    for (std::size_t key = 0; key < 4; ++key) {
        std::set<int> intervals;
        for (std::size_t i = 0; i < kCount; ++i) intervals.insert(static_cast<int>(sample->point(i)[key] * kCount));
        EXPECT_EQ(intervals.size(), kCount);
        EXPECT_EQ(*intervals.rbegin(), static_cast<int>(kCount) - 1);
    }
}

// A point depends on its index alone, so that any share of a study has the same designs.
TEST(Sample, PointsAreTheSameInAnyOrder) {
    for (const Method method : {Method::kRandom, Method::kLatinHypercube, Method::kSobol}) {
        const auto a = make_sample(method, 2, 20, 3), b = make_sample(method, 2, 20, 3);
        std::vector<std::vector<double>> forward, backward;
        for (std::size_t i = 0; i < 20; ++i) forward.push_back(a->point(i)), backward.push_back(b->point(19 - i));
        std::reverse(backward.begin(), backward.end());
        EXPECT_EQ(forward, backward);
        if (method != Method::kSobol) {
            EXPECT_NE(make_sample(method, 2, 20, 4)->point(0), forward.front()) << "another seed";
        }
    }
}

// The mean of n uniform numbers has the standard deviation sqrt(1/12n): 0.0065 here.
TEST(Sample, RandomPointsAreUniform) {
    constexpr std::size_t kCount = 2000;
    const auto sample = make_sample(Method::kRandom, 1, kCount, 1);
    double sum = 0.0;
    for (std::size_t i = 0; i < kCount; ++i) sum += sample->point(i)[0];
    EXPECT_NEAR(sum / kCount, 0.5, 5 * 0.0065);
}

}  // namespace
}  // namespace fusee::study
