#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fusee/spring/law.h"
#include "fusee/spring/laws.h"
#include "fusee/spring/potential.h"
#include "refused.h"

namespace fusee::spring {
namespace {

SpringLawPtr paper_law() {
    const auto law = make_stiction_law({.k = 0.42, .u = 0.03, .c = 0.05, .mu = 0.28, .start_torque = 0.12, .end_torque = 1.0});
    return *with_lead_in(*law, 0.3);
}

TEST(LawSprings, AreTheLawsTwoColumns) {
    const SpringLawPtr law = paper_law();
    const PotentialPtr series = series_spring(law), parallel = parallel_spring(law);
    EXPECT_EQ(series->domain().high, law->angles().high);
    EXPECT_EQ(parallel->domain().low, 0.0);
    for (int i = 0; i <= 20; ++i) {
        const double x = law->angles().high * i / 20.0;
        const LawPoint p = law->at_angle(x);
        EXPECT_EQ(series->energy(x), p.u_se);
        EXPECT_EQ(series->force(x), p.f_se);
        EXPECT_EQ(series->stiffness(x), p.s);
        EXPECT_EQ(series->slope(x), p.s_slope);
        EXPECT_EQ(parallel->energy(x), p.u_pe);
        EXPECT_EQ(parallel->force(x), p.f_pe);
        EXPECT_EQ(parallel->stiffness(x), p.p);
        EXPECT_EQ(parallel->slope(x), p.p_slope);
    }
}

TEST(BehindCable, IsTheSpringInsideItsDomain) {
    const PotentialPtr bare = series_spring(paper_law()), spring = behind_cable(bare);
    EXPECT_EQ(spring->domain().low, bare->domain().low);
    EXPECT_EQ(spring->domain().high, bare->domain().high);
    for (int i = 0; i <= 10; ++i) {
        const double x = bare->domain().high * i / 10.0;
        EXPECT_EQ(spring->energy(x), bare->energy(x));
        EXPECT_EQ(spring->force(x), bare->force(x));
        EXPECT_EQ(spring->stiffness(x), bare->stiffness(x));
        EXPECT_EQ(spring->slope(x), bare->slope(x));
    }
}

/// F = 0.2 + 0.5 x + 0.25 x^2 on [0, 100], stop within 0.01 rad: all by hand.
TEST(BehindCable, GoesOnAsStopSlackAndStraightLine) {
    const double reach = kLongestDeflection;
    const PotentialPtr spring = behind_cable(make_polynomial({0.2, 0.5, 0.25}), 0.01);
    EXPECT_NEAR(spring->force(-0.005), 0.1, 1e-15);
    EXPECT_NEAR(spring->stiffness(-0.005), 20.0, 1e-12);
    EXPECT_NEAR(spring->energy(-0.005), -0.005 * (0.2 + 0.1) / 2.0, 1e-17);
    EXPECT_EQ(spring->force(-0.02), 0.0);
    EXPECT_EQ(spring->stiffness(-5.0), 0.0);
    EXPECT_NEAR(spring->energy(-0.02), -0.001, 1e-17);
    EXPECT_EQ(spring->energy(-7.0), spring->energy(-0.02));
    const double end_stiffness = 0.5 + 0.5 * reach, end_force = 0.2 + 0.5 * reach + 0.25 * reach * reach;
    EXPECT_NEAR(spring->force(reach + 2.0), end_force + 2.0 * end_stiffness, 1e-11);
    EXPECT_EQ(spring->stiffness(reach + 2.0), end_stiffness);
    EXPECT_EQ(spring->slope(reach + 2.0), 0.0);
    EXPECT_NEAR(spring->energy(reach + 2.0) - spring->energy(reach), 2.0 * end_force + 2.0 * end_stiffness, 1e-9);
}

/// The force is the slope of the energy everywhere, the energy is C1 and the force never falls.
TEST(BehindCable, IsC1AndConvexAcrossItsEnds) {
    const SpringLawPtr law = paper_law();
    for (const PotentialPtr& bare : {series_spring(law), parallel_spring(law)}) {
        const double stop = 0.05;
        const PotentialPtr spring = behind_cable(bare, stop);
        const double top = bare->domain().high, h = 1e-6;
        double last = 0.0;
        for (double x = -0.2; x < top + 1.0; x += 0.0137) {
            EXPECT_GE(spring->force(x), last) << x;
            last = spring->force(x);
            // h^2/6 of slopes of order 1 and rounding 1e-16/h of energies of order 1; a kink in the force adds h times its stiffness.
            EXPECT_NEAR((spring->energy(x + h) - spring->energy(x - h)) / (2.0 * h), spring->force(x), 1e-8 + h * 20.0) << x;
        }
        for (const double joint : {-stop, 0.0, top})
            EXPECT_NEAR(spring->force(joint - 1e-12), spring->force(joint + 1e-12), 1e-9) << joint;  // 2e-12 times the stiffness
    }
}

TEST(BehindCable, SpringWithoutPreloadIsSlackBelow) {
    const PotentialPtr spring = behind_cable(make_polynomial({0.0, 1.0}));
    EXPECT_EQ(spring->force(-1e-5), 0.0);
    EXPECT_EQ(spring->energy(-1.0), 0.0);
}

TEST(BehindCableRefusal, BadStopAndPushingSpringAreNamed) {
    EXPECT_EQ(field_refused([] { return behind_cable(make_polynomial({0.1, 1.0}), 0.0); }), "stop_travel");
    EXPECT_EQ(field_refused([] {
                  return behind_cable(make_polynomial({0.1, 1.0}), std::numeric_limits<double>::infinity());
              }),
              "stop_travel");
    EXPECT_EQ(field_refused([] { return behind_cable(make_polynomial({-0.1, 1.0})); }), "spring");
}

}  // namespace
}  // namespace fusee::spring
