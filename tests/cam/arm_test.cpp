#include "fusee/cam/arm.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fixture.h"
#include "fusee/core/error.h"
#include "fusee/spring/law.h"

namespace fusee::cam {
namespace {

using namespace test;

// Known: two linear springs, each loaded from zero, need a constant arm: k_t phi^2/2 = S x^2/2 gives r = r_c sqrt(k_t/S), r = sqrt(P/k).
TEST(Arm, LinearSpringsNeedRoundCams) {
    const double s = 0.08, p = 0.12, start = 0.2, kt = 0.02, k = 3000.0;
    const auto law = spring::make_pair_law(spring::make_polynomial({0.0, s}), spring::make_polynomial({0.0, p}), start, 1.0).value();
    const double x0 = start / (s + p);  // the law's lowest load, reached from zero load with the energy that the preload holds
    const ArmFunction spool(PartKind::kSeries, law, torsion(kt, x0 * std::sqrt(s / kt)), kCapstan);
    const ArmFunction cam(PartKind::kParallel, law, compression(k, x0 * std::sqrt(p / k)), kCapstan);
    for (const double tau : {0.2, 0.5, 1.0}) {
        EXPECT_NEAR(spool.at_load(tau).arm, kCapstan * std::sqrt(kt / s), 1e-14);
        EXPECT_NEAR(cam.at_load(tau).arm, std::sqrt(p / k), 1e-14);
        EXPECT_NEAR(spool.at_load(tau).slope, 0.0, 1e-12);
        EXPECT_NEAR(cam.at_load(tau).second_derivative, 0.0, 1e-12);
    }
}

class ArmLaw : public ::testing::TestWithParam<PartKind> {
protected:
    ArmFunction arm() const { return GetParam() == PartKind::kSeries ? series_arm() : parallel_arm(); }
};

// Law: r' and r'' are the derivatives by the cam's own angle. Central differences over a load step h err by O(h^2): 1e-7 of the value here.
TEST_P(ArmLaw, SlopesAreDerivatives) {
    for (const double tau : {0.7, 1.0, 1.4, 1.9}) {
        const double h = 2e-4;
        const ArmPoint low = arm().at_load(tau - h), mid = arm().at_load(tau), high = arm().at_load(tau + h);
        const double width = high.angle - low.angle;
        EXPECT_NEAR((high.arm - low.arm) / width, mid.slope, 2e-5 * std::abs(mid.slope) + 1e-7) << tau;
        EXPECT_NEAR((high.slope - low.slope) / width, mid.second_derivative, 2e-5 * std::abs(mid.second_derivative) + 1e-6) << tau;
    }
}

// Law: the length of cable that the arm moves is that of the spring law: integral of r dangle = r_c dtheta (K_SE) or dy (K_PE).
TEST_P(ArmLaw, MovesTheRightLengthOfCable) {
    const auto function = arm();
    const core::Range loads = function.law().loads();
    double moved = 0.0;
    constexpr int kSteps = 4000;  // trapezoid over 4000 steps: 1e-7 relative
    ArmPoint earlier = function.at_load(loads.low);
    for (int i = 1; i <= kSteps; ++i) {
        const ArmPoint now = function.at_load(loads.low + loads.width() * i / kSteps);
        moved += 0.5 * (earlier.arm + now.arm) * (now.angle - earlier.angle);
        earlier = now;
    }
    const double expected =
        GetParam() == PartKind::kSeries ? kCapstan * function.law().angles().width() : earlier.state - function.base().preload;
    EXPECT_NEAR(moved, expected, 1e-6 * expected);
}

INSTANTIATE_TEST_SUITE_P(BothCams, ArmLaw, ::testing::Values(PartKind::kSeries, PartKind::kParallel),
                         [](const auto& instance) { return std::string(to_string(instance.param)); });

// The lead-in joins the law with U''' continuous, so arm, slope and second derivative have no jump at its end (0.6 Nm); r''' may have one:
// over the 2e-7 Nm between both sides the second derivative changes by about 1e-6, relative.
TEST(Arm, IsSmoothWhereTheLeadInEnds) {
    const auto law = spring::with_lead_in(stiction_law(), 0.05).value();
    for (const ArmFunction& arm : {ArmFunction(PartKind::kSeries, law, torsion(0.0183, 3.7), kCapstan),
                                   ArmFunction(PartKind::kParallel, law, compression(7460.0, 0.0146), kCapstan)}) {
        const ArmPoint below = arm.at_load(0.6 - 1e-7), above = arm.at_load(0.6 + 1e-7);
        EXPECT_NEAR(below.arm, above.arm, 1e-5 * above.arm);
        EXPECT_NEAR(below.slope, above.slope, 1e-4 * std::abs(above.slope));
        EXPECT_NEAR(below.second_derivative, above.second_derivative, 1e-4 * std::abs(above.second_derivative));
    }
}

// The allowance changes the arm only: cable, angle, state, slope and second derivative are those of the required arm.
TEST(Arm, IsReducedByTheAllowance) {
    for (const PartKind kind : {PartKind::kSeries, PartKind::kParallel}) {
        const spring::BaseSpring base = kind == PartKind::kSeries ? torsion() : compression();
        const ArmFunction wanted(kind, stiction_law(), base, kCapstan), cut(kind, stiction_law(), base, kCapstan, {.radius = 3e-4});
        const ArmPoint a = wanted.at_load(1.1), b = cut.at_load(1.1), c = cut.on(base).at_load(1.1);
        EXPECT_DOUBLE_EQ(b.arm, a.arm - 3e-4);
        EXPECT_EQ(c.arm, b.arm);
        EXPECT_EQ(b.slope, a.slope);
        EXPECT_EQ(b.second_derivative, a.second_derivative);
        EXPECT_EQ(b.tension, a.tension);
        EXPECT_EQ(b.angle, a.angle);
    }
}

// Known: behind a compliance c a law of stiffness S needs a spool of stiffness S/(1 - c S); of a straight one without preload the arm is
// r_c sqrt(k_t (1 - c S)/S). Slope and second derivative remain derivatives by the spool's own angle (steps as above).
TEST(Arm, CompensatesForAnElasticCable) {
    const double s = 0.08, p = 0.12, start = 0.2, kt = 0.02, c = 4.0;
    const auto straight = spring::make_pair_law(spring::make_polynomial({0.0, s}), spring::make_polynomial({0.0, p}), start, 1.0).value();
    const double x0 = start / (s + p), own = s / (1.0 - c * s);
    const ArmFunction spool(PartKind::kSeries, straight, torsion(kt, s * x0 / std::sqrt(kt * own)), kCapstan, {.series_compliance = c});
    for (const double tau : {0.2, 0.5, 1.0}) EXPECT_NEAR(spool.at_load(tau).arm, kCapstan * std::sqrt(kt / own), 1e-13);
    const ArmFunction curved(PartKind::kSeries, stiction_law(), torsion(), kCapstan, {.series_compliance = 0.2});
    expect_derivatives(curved, {0.7, 1.4, 1.9});
    EXPECT_THROW(ArmFunction(PartKind::kSeries, straight, torsion(), kCapstan, {.series_compliance = 1.01 / s}), core::InvalidInput);
    EXPECT_THROW(ArmFunction(PartKind::kSeries, straight, torsion(), kCapstan, {.series_compliance = -0.1}), core::InvalidInput);
}

TEST(Arm, RefusesTheWrongSpring) {
    EXPECT_THROW(ArmFunction(PartKind::kSeries, stiction_law(), compression(), kCapstan), core::InvalidInput);
    EXPECT_THROW(ArmFunction(PartKind::kParallel, stiction_law(), compression(-1.0), kCapstan), core::InvalidInput);
    EXPECT_THROW(ArmFunction(PartKind::kSeries, stiction_law(), torsion(), 0.0), core::InvalidInput);
}

}  // namespace
}  // namespace fusee::cam
