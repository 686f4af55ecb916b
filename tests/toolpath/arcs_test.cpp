#include <gtest/gtest.h>

#include <cmath>

#include "fusee/core/units.h"
#include "gcode.h"

namespace fusee::toolpath {
namespace {

using solid::Point2;

double dot(const Point2& a, double psi) { return a[0] * std::cos(psi) + a[1] * std::sin(psi); }

/// Support function h = 10 + cos 2 psi: rho = 10 - 3 cos 2 psi, from 7 to 13 mm.
Point2 oval(double psi) {
    const double h = 10.0 + std::cos(2.0 * psi), slope = -2.0 * std::sin(2.0 * psi), c = std::cos(psi), s = std::sin(psi);
    return {h * c - slope * s, h * s + slope * c};
}

TEST(Arcs, OfACircleAreThatCircle) {
    const auto circle = [](double psi) { return Point2{3.0 + 5.0 * std::cos(psi), 5.0 * std::sin(psi)}; };
    for (const solid::Arc& arc : fit_arcs(circle, 0.7, 1e-6)) {
        EXPECT_NEAR(arc.radius_mm, 5.0, 1e-9);
        EXPECT_NEAR(arc.centre_mm[0], 3.0, 1e-9);
        EXPECT_NEAR(arc.centre_mm[1], 0.0, 1e-9);
    }
}

TEST(Arcs, KeepTheToleranceAndMeetWithoutACorner) {
    for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
        const auto ring = fit_arcs(oval, 0.3, tolerance);
        double worst = 0.0;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const solid::Arc &arc = ring[i], &next = ring[(i + 1) % ring.size()];
            const Point2 end = arc.at(arc.end), begin = next.at(next.begin);
            EXPECT_NEAR(std::hypot(end[0] - begin[0], end[1] - begin[1]), 0.0, 1e-9);
            EXPECT_NEAR(std::remainder(arc.end - next.begin, 2.0 * core::kPi), 0.0, 1e-12);
            for (int k = 0; k <= 20; ++k) {
                const double psi = arc.begin + (arc.end - arc.begin) * k / 20.0;
                worst = std::max(worst, std::abs(dot(arc.at(psi), psi) - dot(oval(psi), psi)));
            }
        }
        EXPECT_LE(worst, 1.05 * tolerance);  // it is probed at 4 normals of an arc, seen here at 21
        EXPECT_GT(worst, 0.01 * tolerance);  // and no finer than asked for: arcs are few
    }
}

// The error of a pair of arcs falls with the third power of its width, so that arcs grow as the cube root.
TEST(Arcs, GrowSlowlyInNumber) {
    EXPECT_LT(static_cast<double>(fit_arcs(oval, 0.0, 1e-4).size()), 3.0 * static_cast<double>(fit_arcs(oval, 0.0, 1e-2).size()) + 96.0);
}

TEST(Arcs, TurnedOverAreMirroredAboutX) {
    const auto ring = fit_arcs(oval, 0.3, 1e-3), turned = turned_over(ring);
    ASSERT_EQ(turned.size(), ring.size());
    EXPECT_NEAR(std::remainder(turned.front().begin + ring.back().end, 2.0 * core::kPi), 0.0, 1e-12);
    for (const solid::Arc& arc : turned) {
        EXPECT_LT(arc.begin, arc.end);
        const double psi = 0.5 * (arc.begin + arc.end);
        EXPECT_NEAR(dot(arc.at(psi), psi), dot(oval(-psi), -psi), 1e-3);
    }
}

}  // namespace
}  // namespace fusee::toolpath
