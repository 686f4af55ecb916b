#include "bezier_patch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"

namespace fusee::exchange {
namespace {

/// A quarter of a cylinder about (x, 0), from azimuth 0 to 90 deg about its own axis, between the heights 0 and 1: rational in t.
BezierPatch quarter(double x, double radius) {
    BezierPatch patch{2, 3, {}};
    const double w = std::sqrt(0.5);
    for (const double z : {0.0, 1.0})
        for (const auto& [px, py, weight] : {std::array{x + radius, 0.0, 1.0}, {x + radius, radius, w}, {x, radius, 1.0}})
            patch.poles.push_back({weight * px, weight * py, weight * z, weight});
    return patch;
}

// Known answer: the circle about (e, 0) seen from the axis at azimuth a: r = e cos a + sqrt(R^2 - e^2 sin^2 a).
TEST(BezierPatch, ALineMeetsACylinderWhereKnown) {
    constexpr double kRadius = 10.0, kEccentric = 3.0;
    const BezierPatch patch = quarter(kEccentric, kRadius);
    for (double a = 0.05; a < 1.2; a += 0.05) {
        const double r = kEccentric * std::cos(a) + std::sqrt(kRadius * kRadius - std::pow(kEccentric * std::sin(a), 2));
        const auto found = crossings(patch, a, 0.25);
        ASSERT_EQ(found.size(), 1u) << a;
        EXPECT_NEAR(found.front().s, 0.25, 1e-12);
        const double t = found.front().t, w = std::sqrt(0.5);
        const double b0 = (1 - t) * (1 - t), b1 = 2 * t * (1 - t) * w, b2 = t * t, weight = b0 + b1 + b2;
        const double x = kEccentric + kRadius * (b0 + b1) / weight, y = kRadius * (b1 + b2) / weight;
        EXPECT_NEAR(x, r * std::cos(a), 1e-9);
        EXPECT_NEAR(y, r * std::sin(a), 1e-9);
    }
    EXPECT_TRUE(crossings(patch, 2.5, 0.25).empty());
    EXPECT_TRUE(crossings(patch, 0.5, 1.01).empty());
}

// A line through the border of two patches finds it in both.
TEST(BezierPatch, ItsBorderBelongsToIt) {
    const BezierPatch patch = quarter(0.0, 10.0);
    for (const double z : {0.0, 1.0}) EXPECT_EQ(crossings(patch, 0.7, z).size(), 1u) << z;
    for (const double a : {0.0, 0.5 * core::kPi}) EXPECT_EQ(crossings(patch, a, 0.5).size(), 1u) << a;
}

// Known answer: y = 100 (t - 0.2)(t - 0.5)(t - 0.9) has three roots; the patch bends back over the line twice.
TEST(BezierPatch, FindsEveryCrossingOfABentPatch) {
    // Bernstein coefficients of (t - 0.2)(t - 0.5)(t - 0.9)
    const auto blossom = [](double p, double q, double r) {
        const auto term = [&](double a, double b, double c) { return (p - a) * (q - b) * (r - c); };
        return (term(0.2, 0.5, 0.9) + term(0.2, 0.9, 0.5) + term(0.5, 0.2, 0.9) + term(0.5, 0.9, 0.2) + term(0.9, 0.2, 0.5) +
                term(0.9, 0.5, 0.2)) /
               6.0;
    };
    BezierPatch patch{2, 4, {}};
    for (const double z : {-1.0, 1.0})
        for (int k = 0; k < 4; ++k) patch.poles.push_back({5.0 + k / 3.0, 100.0 * blossom(k > 2, k > 1, k > 0), z, 1.0});
    auto found = crossings(patch, 0.0, 0.0);
    ASSERT_EQ(found.size(), 3u);
    std::sort(found.begin(), found.end(), [](const PatchPoint& a, const PatchPoint& b) { return a.t < b.t; });
    EXPECT_NEAR(found[0].t, 0.2, 1e-9);
    EXPECT_NEAR(found[1].t, 0.5, 1e-9);
    EXPECT_NEAR(found[2].t, 0.9, 1e-9);
}

}  // namespace
}  // namespace fusee::exchange
