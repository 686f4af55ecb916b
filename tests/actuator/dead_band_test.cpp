#include "fusee/actuator/dead_band.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "actuator/with_law.h"
#include "fusee/core/error.h"
#include "fusee/spring/law.h"
#include "fusee/spring/laws.h"
#include "fusee/spring/potential.h"

namespace fusee::actuator {
namespace {

spring::SpringLawPtr soft_law(double end) {
    return *spring::make_stiction_law({.k = 0.225, .u = 0.0012, .c = 0.265, .mu = kMu, .start_torque = 0.6, .end_torque = end});
}

/// The widest pair of resting places by exhaustive search over a grid of deflections: no root is solved, nothing assumed about the edge.
double widest_by_search(const Actuator& actuator, double tau) {
    constexpr int kGrid = 1200;
    const double reach = actuator.law->angles().high, low = tau / (1.0 + kMu), high = tau / (1.0 - kMu);
    std::vector<spring::LawPoint> at;
    for (int i = 0; i <= kGrid; ++i) at.push_back(actuator.law->at_angle(reach * i / kGrid));
    const auto held = [&](int x, int theta) {
        const double load = at[static_cast<std::size_t>(x)].f_se + at[static_cast<std::size_t>(theta)].f_pe;
        return load >= low && load <= high;
    };
    int widest = 0;
    for (int x = 0; x <= kGrid; ++x)
        for (int q = widest + 1; q <= std::min(x, kGrid - x); ++q)
            if (held(x, x - q) && held(x, x + q)) widest = q;
    return 2.0 * reach * widest / kGrid;
}

TEST(DeadBand, LinearWidthsOfADesignAreKnown) {
    const auto law = spring::make_stiction_law({.k = 0.69, .u = 0.0027, .c = 0.30, .mu = kMu, .start_torque = 0.5, .end_torque = 1.5});
    const Actuator actuator = with_law(*law);
    EXPECT_NEAR(core::deg_from_rad(dead_band(actuator, 0.5).linear), 140.0, 0.5);  // the reference is rounded there
    EXPECT_NEAR(core::deg_from_rad(dead_band(actuator, 1.0).linear), 19.9, 0.05);
    EXPECT_NEAR(core::deg_from_rad(dead_band(actuator, 1.5).linear), 7.8, 0.05);
}

TEST(DeadBand, ExactWidthAgreesWithExhaustiveSearch) {
    const Actuator actuator = with_law(soft_law(2.4));
    EXPECT_NEAR(core::deg_from_rad(dead_band(actuator, 1.0).exact_width), 51.3, 0.05);
    for (const double tau : {1.0, 1.25, 1.5}) {
        const DeadBand band = dead_band(actuator, tau);
        ASSERT_TRUE(band.covered) << tau;
        // The search loses up to two steps of q and one of x to its grid.
        const double step = 2.0 * actuator.law->angles().high / 1200.0;
        EXPECT_LE(widest_by_search(actuator, tau), band.exact_width + 1e-12) << tau;
        EXPECT_NEAR(widest_by_search(actuator, tau), band.exact_width, 3.0 * step) << tau;
    }
}

/// Linear springs: the edges solve S x + P (x -+ q) = loads, so 2 q = (high - low)/P for any S.
TEST(DeadBand, LinearSpringsAreKnownByHand) {
    const double s = 0.4, p = 0.6;
    const auto law = spring::make_pair_law(spring::make_polynomial({0.0, s}), spring::make_polynomial({0.0, p}), 0.05, 20.0);
    ASSERT_TRUE(law);
    const double g = 1.5;
    const DeadBand band = dead_band(with_law(*law, kMu, g), 1.0);
    EXPECT_TRUE(band.covered);
    EXPECT_NEAR(band.exact_width, (1.0 / (1.0 - kMu) - 1.0 / (1.0 + kMu)) / (p * g), 1e-12);
    EXPECT_NEAR(band.linear, 2.0 * kMu / (p * g), 1e-14);
    EXPECT_NEAR(band.joint_stiffness, 2.0 * g * g * s, 1e-14);
    EXPECT_NEAR(band.free_joint_stiffness, 2.0 * g * g * s * p / (s + p), 1e-14);
    EXPECT_NEAR(band.theta, 1.0 / (s + p) - 0.05, 1e-13);
    EXPECT_NEAR(band.condition_6, kMu * s / (s + p), 1e-14);  // constant T: the dead-band grows with load
}

TEST(DeadBand, ExactTendsToLinearAsFrictionVanishes) {
    const spring::SpringLawPtr law = soft_law(2.4);
    for (const double mu : {1e-2, 1e-3, 1e-4}) {
        const DeadBand band = dead_band(with_law(law, mu), 1.2);
        EXPECT_NEAR(band.exact_width / band.linear, 1.0, 20.0 * mu * mu + 1e-9);  // symmetric in +-mu to first order
    }
    EXPECT_EQ(dead_band(with_law(law, 0.0), 1.2).exact_width, 0.0);
}

TEST(DeadBand, Condition6IsTheSlopeOfTheTransmittedStiction) {
    const Actuator actuator = with_law(soft_law(2.4));
    const auto transmitted = [&](double tau) { return actuator.law->at_load(tau).transmission() * kMu * tau; };
    const double h = 1e-5;
    for (const double tau : {0.7, 1.0, 1.4, 2.0}) {
        EXPECT_NEAR(dead_band(actuator, tau).condition_6, (transmitted(tau + h) - transmitted(tau - h)) / (2.0 * h), 1e-10);
        // The law is made so that T tau_f = u^2/tau + mu C falls as -u^2/tau^2.
        EXPECT_NEAR(dead_band(actuator, tau).condition_6, -0.0012 * 0.0012 / (tau * tau), 1e-14);
    }
}

TEST(DeadBand, UncoveredLoadsAreSaid) {
    const DeadBand low = dead_band(with_law(soft_law(2.4)), 0.65);  // needs 0.508 Nm, the law starts at 0.6
    EXPECT_FALSE(low.covered);
    EXPECT_TRUE(std::isnan(low.exact_width));
    EXPECT_FALSE(std::isnan(low.linear));
    const DeadBand outside = dead_band(with_law(soft_law(2.4)), 0.5);
    EXPECT_TRUE(std::isnan(outside.linear));
    // 1.5/(1 - mu) = 2.083 Nm lies in the law, but capstan 2 turns farther than it would under that load at rest.
    EXPECT_FALSE(dead_band(with_law(soft_law(2.1)), 1.5).covered);
    EXPECT_TRUE(dead_band(with_law(soft_law(2.21)), 1.5).covered);
    const auto longer = spring::with_lead_in(soft_law(2.4), 1.5);
    EXPECT_TRUE(dead_band(with_law(*longer), 0.8).covered);
}

// Rounding at the ends of the search once left holes: the width rises steadily with the torque, so it must be there at every torque.
TEST(DeadBand, CoverHasNoHoles) {
    const auto law =
        spring::make_pair_law(spring::make_polynomial({0.0, 0.10, 0.02}), spring::make_polynomial({0.0, 0.25, 0.03}), 0.06, 1.65);
    const Actuator actuator = with_law(*law);
    double earlier = 0.0;
    for (double tau = 0.12; tau <= 1.0; tau += 0.001) {
        const DeadBand band = dead_band(actuator, tau);
        ASSERT_TRUE(band.covered) << tau;
        EXPECT_GT(band.exact_width, earlier) << tau;
        earlier = band.exact_width;
    }
}

TEST(DeadBandCurve, RunsFromLeastToOverdrive) {
    const Actuator actuator = with_law(soft_law(2.4));
    const auto curve = dead_band_curve(actuator, 8);
    ASSERT_EQ(curve.size(), 8u);
    EXPECT_EQ(curve.front().tau, 0.8);
    EXPECT_NEAR(curve[1].tau, 0.9, 1e-15);
    EXPECT_EQ(curve.back().tau, 1.5);
    for (std::size_t i = 1; i < curve.size(); ++i) EXPECT_LT(curve[i].linear, curve[i - 1].linear);
    EXPECT_THROW((void)dead_band_curve(actuator, 1), core::InvalidInput);
}

spring::SpringLawPtr prototype_law() {
    return *spring::make_pair_law(spring::make_polynomial({0.0, 0.10, 0.02}), spring::make_polynomial({0.0, 0.25, 0.03}), 0.06, 1.65);
}

TEST(DeadBand, FollowsAnyFrictionLaw) {
    Actuator actuator = with_law(prototype_law());
    actuator.gear_friction = spring::FrictionLaw::affine(0.02, 0.2, 0.25);  // 0.025 + 0.25 tau at rest
    const DeadBand band = dead_band(actuator, 0.6);
    EXPECT_NEAR(band.linear, 2.0 * 0.175 / actuator.law->at_load(0.6).p, 1e-14);
    const auto transmitted = [&](double tau) { return actuator.law->at_load(tau).transmission() * (0.025 + 0.25 * tau); };
    const double h = 1e-4;
    EXPECT_NEAR(band.condition_6, (transmitted(0.6 + h) - transmitted(0.6 - h)) / (2.0 * h), 1e-9);
    // Linear springs: (high - low)/P with the loads of the law, 0.775/1.25 Nm below and 0.825/0.75 Nm above 0.8 Nm.
    const auto linear = spring::make_pair_law(spring::make_polynomial({0.0, 0.4}), spring::make_polynomial({0.0, 0.6}), 0.01, 20.0);
    actuator.law = *linear;
    EXPECT_NEAR(dead_band(actuator, 0.8).exact_width, (0.825 / 0.75 - 0.775 / 1.25) / 0.6, 1e-12);
    // A motor weaker than the constant part of the friction holds the capstan where its cable is slack: no law covers that.
    EXPECT_FALSE(dead_band(actuator, 0.02).covered);
}

/// P(6) over the whole range: the first prototype fails it everywhere, the springs made for it hold it everywhere.
TEST(ConditionSummary, FirstPrototypeFailsAndTheStictionCompensatingLawHolds) {
    Actuator prototype = with_law(prototype_law());
    prototype.least_torque = 0.12;  // table I
    const ConditionSummary fails = summarize_condition(prototype);
    EXPECT_TRUE(fails.nowhere());
    EXPECT_FALSE(fails.everywhere());
    EXPECT_GT(fails.values.low, 0.0);
    EXPECT_EQ(fails.torques.low, 0.12);
    const ConditionSummary holds = summarize_condition(with_law(soft_law(2.21)));
    EXPECT_TRUE(holds.everywhere());
    ASSERT_EQ(holds.holds.size(), 1u);
    EXPECT_EQ(holds.holds[0].low, 0.8);
    EXPECT_EQ(holds.holds[0].high, 1.5);
    EXPECT_NEAR(holds.values.high, -0.0012 * 0.0012 / (1.5 * 1.5), 1e-14);
}

/// Into its lead-in the law carries on with slopes that fade: the condition is lost there, and the summary says where.
TEST(ConditionSummary, FindsTheTorqueFromWhichItHolds) {
    Actuator actuator = with_law(*spring::with_lead_in(soft_law(2.4), 1.0));
    actuator.least_torque = actuator.law->loads().low;
    const ConditionSummary summary = summarize_condition(actuator);
    EXPECT_FALSE(summary.everywhere());
    ASSERT_EQ(summary.holds.size(), 1u);
    EXPECT_GT(summary.holds[0].low, actuator.least_torque);
    EXPECT_LT(summary.holds[0].low, 0.6);
    EXPECT_EQ(summary.holds[0].high, 1.5);
    EXPECT_NEAR(dead_band(actuator, summary.holds[0].low).condition_6, 0.0, 1e-9);
    actuator.law = soft_law(0.7);
    EXPECT_LT(summarize_condition(actuator).torques.low, 0.7 + 1e-15);
    actuator.least_torque = 0.9;
    EXPECT_TRUE(summarize_condition(actuator).nowhere());
    EXPECT_TRUE(std::isnan(summarize_condition(actuator).values.high));
}

}  // namespace
}  // namespace fusee::actuator
