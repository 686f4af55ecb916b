#include "fusee/mjcf/curve.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fusee/core/error.h"
#include "fusee/spring/potential.h"

using namespace fusee;
using fusee::mjcf::Cubic;
using fusee::mjcf::Curve;

namespace {

/// F = 0.1 + 0.2 x + 0.05 x^3 from 0 to 2 rad, behind a cable.
spring::PotentialPtr cubic_spring() {
    class Short final : public spring::Potential {
        core::Range domain() const override { return {0.0, 2.0}; }
        double energy(double x) const override { return 0.1 * x + 0.1 * x * x + 0.0125 * x * x * x * x; }
        double force(double x) const override { return 0.1 + 0.2 * x + 0.05 * x * x * x; }
        double stiffness(double x) const override { return 0.2 + 0.15 * x * x; }
        double slope(double x) const override { return 0.3 * x; }
    };
    return spring::behind_cable(std::make_shared<Short>());
}

}  // namespace

TEST(MjcfCurve, IsTheSpringBetweenItsRowsAndBeyondThem) {
    const spring::PotentialPtr spring = cubic_spring();
    const Curve curve = mjcf::tabulate(*spring, 1e-4);
    EXPECT_LE(curve.table_error, 1e-5 * curve.greatest());
    for (const double x : {0.0, 0.0013, 0.777, 1.9999, 2.0, 2.5}) EXPECT_NEAR(curve.at(x), spring->force(x), 1e-5 * 0.9) << x;
    EXPECT_NEAR(curve.at(-3e-5), spring->force(-3e-5), 1e-12);  // on the stop
    EXPECT_EQ(curve.at(-2e-4), 0.0);                            // slack
    EXPECT_NEAR(curve.at(3.0), 0.9 + 0.8 * 1.0, 1e-12);         // straight on with F'(2) = 0.8
    EXPECT_NEAR(curve.greatest_stiffness(), 0.8, 1e-12);
}

TEST(MjcfCurve, TakesTheStopThatItIsGiven) {
    const Curve curve = mjcf::tabulate(*cubic_spring(), 0.02);
    EXPECT_NEAR(curve.at(-0.01), 0.05, 1e-12);
    EXPECT_THROW((void)mjcf::tabulate(*cubic_spring(), 0.0), core::InvalidInput);
}

TEST(MjcfCurve, IsTheSpringOfABuiltRig) {
    const joint_model::CamSpring spring({0.0, 0.5, 1.5}, {0.02, 0.1, 0.5}, 0.3);  // flatter beyond the end
    const Curve curve = mjcf::tabulate(spring, 0.1);
    EXPECT_EQ(curve.hysteresis, 0.1);
    for (const double x : {-0.02, -0.004, 0.0011, 0.3, 0.7501, 1.5, 1.7, 3.0}) EXPECT_NEAR(curve.at(x), spring.torque(x), 1e-9) << x;
}

TEST(MjcfCubic, ACubicSpringIsExact) {
    const Curve curve = mjcf::tabulate(*cubic_spring(), 1e-4);
    const Cubic fit = mjcf::fit_cubic(curve);
    EXPECT_LT(fit.worst, 2e-5);                                                            // the table's own error
    EXPECT_NEAR(0.1 + 0.2 * fit.free + 0.05 * fit.free * fit.free * fit.free, 0.0, 2e-4);  // its only real zero
    EXPECT_NEAR(fit.cube, 0.05, 1e-4);
    EXPECT_EQ(fit.at(fit.free - 0.1), 0.0);
    EXPECT_NEAR(fit.at(1.0), 0.35, 2e-5);
}

TEST(MjcfCubic, StatesItsGreatestErrorAndNeverPushes) {
    Curve curve;  // a corner that a cubic cannot follow
    curve.high = 2.0;
    for (int i = 0; i <= 200; ++i) curve.torque.push_back(0.1 + 0.001 * i + std::max(0.0, 0.02 * i - 2.0));
    curve.end_stiffness = 2.1;
    const Cubic fit = mjcf::fit_cubic(curve);
    double worst = 0.0, at = 0.0;
    for (int i = 0; i <= 200; ++i) {
        const double x = 0.01 * i, error = std::abs(fit.at(x) - curve.at(x));
        EXPECT_GE(fit.at(x), 0.0);
        if (error > worst) worst = error, at = x;
    }
    EXPECT_NEAR(fit.worst, worst, 1e-9);
    EXPECT_NEAR(fit.worst_at, at, 1e-9);
    EXPECT_GT(fit.worst, 0.02);
    EXPECT_LT(fit.worst, 0.2);
}

TEST(MjcfCubic, FollowsASpringThatBeginsSlack) {
    Curve curve;  // 0 up to 1 rad, then straight
    curve.high = 2.0;
    for (int i = 0; i <= 200; ++i) curve.torque.push_back(std::max(0.0, 0.01 * i - 1.0));
    curve.end_stiffness = 1.0;
    const Cubic fit = mjcf::fit_cubic(curve);
    EXPECT_LT(fit.worst, 1e-6);
    EXPECT_NEAR(fit.free, 1.0, 1e-6);
    EXPECT_NEAR(fit.linear, 1.0, 1e-4);
}
