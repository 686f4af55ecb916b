#include "idle_arc.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace fusee::cam {
namespace {

// Known: between two mirror images the arc is its own mirror image; that of a circle stays inside the circle's tangents (rho' = 0 at
// mid-arc).
TEST(IdleArc, IsSymmetricBetweenMirroredEnds) {
    const SupportState begin{0.01, 1e-3, 0.008}, end{0.01, -1e-3, 0.008};
    const auto arc = IdleArc::close(begin, end, 2.5, {1e-3, 0.0});
    ASSERT_TRUE(arc);
    for (double x = 0.0; x <= 1.25; x += 0.1) {
        EXPECT_NEAR(arc->at(x).h, arc->at(2.5 - x).h, 1e-12) << x;
        EXPECT_NEAR(arc->at(x).slope, -arc->at(2.5 - x).slope, 1e-12) << x;
    }
    EXPECT_NEAR(arc->at(1.25).slope, 0.0, 1e-12);
}

// Law: both ends are met with h, h', rho; h is the integral of h'; rho never falls below the least radius.
TEST(IdleArc, MeetsBothEndsAndStaysConvex) {
    const SupportState begin{9.5e-3, 39e-3, 0.47}, end{3e-3, 0.3e-3, 2.9e-3};
    const double width = 4.7, least = 2e-3;
    const auto arc = IdleArc::close(begin, end, width, {least, 0.0});
    ASSERT_TRUE(arc);
    EXPECT_NEAR(arc->at(width).h, end.h, 1e-12);
    EXPECT_NEAR(arc->at(width).slope, end.slope, 1e-12);
    EXPECT_NEAR(arc->at(width).rho, end.rho, 1e-15);
    EXPECT_NEAR(arc->at(0.0).h, begin.h, 1e-15);
    for (double x = 0.0; x < width; x += 0.01) EXPECT_GE(arc->at(x).rho, least * (1.0 - 1e-9)) << x;
    for (double x = 0.5; x < width - 0.1; x += 0.37) {
        const double h = 1e-5;
        EXPECT_NEAR((arc->at(x + h).h - arc->at(x - h).h) / (2 * h), arc->at(x).slope, 1e-9) << x;
        EXPECT_NEAR((arc->at(x + h).slope - arc->at(x - h).slope) / (2 * h), arc->at(x).rho - arc->at(x).h, 1e-6) << x;
    }
}

// Known: a circle about the axis can be closed by itself, so a distance of 99 % of its radius can be kept; the compact arc alone dips to 91
// %.
TEST(IdleArc, KeepsItsDistanceFromTheAxis) {
    const SupportState circle{0.01, 0.0, 0.01};
    const auto least_of = [&](double h) {
        const auto arc = IdleArc::close(circle, circle, 2.5, {1e-3, h});
        double least = 1.0;
        for (double x = 0.0; x <= 2.5; x += 0.01) least = std::min(least, arc->at(x).h);
        return least;
    };
    EXPECT_LT(least_of(0.0), 0.0095);
    EXPECT_GE(least_of(0.0099), 0.0099 * (1.0 - 1e-4));
}

TEST(IdleArc, RefusesWhatNoConvexArcCanClose) {
    // 25 mm down to 5 mm within 30 degrees: the tangent alone cannot come down that fast.
    const auto arc = IdleArc::close({25e-3, 0.0, 25e-3}, {5e-3, 0.0, 5e-3}, 0.5, {2e-3, 0.0});
    ASSERT_FALSE(arc);
    EXPECT_EQ(arc.refusal().front().rule, "cam.idle_arc");
    EXPECT_FALSE(arc.refusal().front().suggestion.empty());
}

TEST(IdleArc, RunOutEndsInTheFinalRadius) {
    const IdleArc arc = IdleArc::run_out({9e-3, 2e-3, 0.2}, 0.8, 9e-3);
    EXPECT_NEAR(arc.at(0.8).rho, 9e-3, 1e-15);
    EXPECT_NEAR(arc.at(0.0).rho, 0.2, 1e-15);
    for (double x = 0.0; x < 0.8; x += 0.01) EXPECT_GT(arc.at(x).rho, 8.9e-3);
}

}  // namespace
}  // namespace fusee::cam
