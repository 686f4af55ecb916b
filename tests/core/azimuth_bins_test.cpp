#include "fusee/core/azimuth_bins.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "fusee/core/units.h"

namespace fusee::core {
namespace {

using Point = std::array<double, 2>;

bool holds(const AzimuthBins& bins, double azimuth, std::uint32_t item) {
    const auto& there = bins.at(azimuth);
    return std::find(there.begin(), there.end(), item) != there.end();
}

TEST(AzimuthBins, ARayFindsEveryHullThatItMeets) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-10.0, 10.0), share(0.0, 1.0);
    AzimuthBins bins;
    std::vector<std::array<Point, 3>> hulls;
    for (std::uint32_t i = 0; i < 500; ++i) {
        hulls.push_back({Point{place(random), place(random)}, Point{place(random), place(random)}, Point{place(random), place(random)}});
        bins.add(i, hulls.back());
    }
    for (std::uint32_t i = 0; i < hulls.size(); ++i)
        for (int k = 0; k < 50; ++k) {
            const double a = share(random), b = (1.0 - a) * share(random);
            const auto& [p, q, r] = hulls[i];
            const double x = p[0] + a * (q[0] - p[0]) + b * (r[0] - p[0]), y = p[1] + a * (q[1] - p[1]) + b * (r[1] - p[1]);
            EXPECT_TRUE(holds(bins, std::atan2(y, x), i));
            EXPECT_TRUE(holds(bins, std::atan2(y, x) + kTurn, i));
        }
}

TEST(AzimuthBins, AnItemIsFoundNearItsAzimuthOnly) {
    AzimuthBins bins;
    bins.add(7, std::array{Point{1.0, -0.1}, Point{1.0, 0.1}, Point{2.0, 0.0}});  // across azimuth 0, 0.1 rad to each side
    for (const double azimuth : {-0.09, 0.0, 0.09, kTurn - 0.05}) EXPECT_TRUE(holds(bins, azimuth, 7)) << azimuth;
    for (const double azimuth : {0.15, 3.0, kTurn - 0.15}) EXPECT_FALSE(holds(bins, azimuth, 7)) << azimuth;
}

TEST(AzimuthBins, AHullWithTheAxisIsFoundEverywhere) {
    AzimuthBins bins;
    bins.add(1, std::array{Point{0.0, 0.0}, Point{1.0, 0.0}});
    bins.add(2, std::array{Point{1.0, 1.0}, Point{-1.0, 1.0}, Point{0.0, -1.0}});
    for (double azimuth = 0.0; azimuth < kTurn; azimuth += 0.1) {
        EXPECT_TRUE(holds(bins, azimuth, 1));
        EXPECT_TRUE(holds(bins, azimuth, 2));
    }
}

}  // namespace
}  // namespace fusee::core
