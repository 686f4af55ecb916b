#include "fusee/design/robust.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fusee/actuator/dead_band.h"
#include "fusee/core/error.h"
#include "fusee/spring/laws.h"
#include "fusee/spring/potential.h"
#include "refused.h"
#include "sampled_dead_band.h"

namespace fusee::design {
namespace {

constexpr double kMu = 0.28;

/// The shipped springs, their law going on far enough for the scatter to stay on it.
DrawnJoint paper(double end = 2.7) {
    actuator::Actuator rig;
    rig.law = *spring::make_stiction_law({.k = 0.225, .u = 0.0012, .c = 0.265, .mu = kMu, .start_torque = 0.6, .end_torque = end});
    rig.capstan_radius = 0.03;
    rig.joint_radius = 0.045;
    rig.gear_friction = spring::FrictionLaw::proportional(kMu);
    rig.least_torque = 0.85;
    rig.peak_torque = 1.0;
    rig.overdrive_torque = 1.5;
    return {.actuator = rig,
            .base_se = {.kind = spring::BaseKind::kTorsion, .rate = 0.0183, .preload = 3.7},
            .base_pe = {.kind = spring::BaseKind::kCompression, .rate = 7460.0, .preload = 0.0146}};
}

/// Linear springs of stiffness s and p.
constexpr double kS = 0.4, kP = 0.6;
DrawnJoint linear(double mu = kMu) {
    DrawnJoint drawn = paper();
    drawn.actuator.law = *spring::make_pair_law(spring::make_polynomial({0.0, kS}), spring::make_polynomial({0.0, kP}), 0.05, 20.0);
    drawn.actuator.gear_friction = spring::FrictionLaw::proportional(mu);
    return drawn;
}

/// Width between the edges of a joint whose springs are straight lines, by hand: both series springs carry F, and so their stretches
/// F/s_1 + F/s_2 are the capstans' (L_1 - F)/p_1 + (L_2 - F)/p_2. Forces count from the straight lines' zero.
struct Straight {
    double s[2] = {kS, kS}, p[2] = {kP, kP}, mu[2] = {kMu, kMu};
    [[nodiscard]] double edge(double l1, double l2, double g) const {
        const double f = (l1 / p[0] + l2 / p[1]) / (1.0 / s[0] + 1.0 / s[1] + 1.0 / p[0] + 1.0 / p[1]);
        return (f / s[0] - (l1 - f) / p[0]) / g;
    }
    [[nodiscard]] double width(double tau, double g) const {
        return edge(tau / (1.0 + mu[0]), tau / (1.0 - mu[1]), g) - edge(tau / (1.0 - mu[0]), tau / (1.0 + mu[1]), g);
    }
};

/// Change of the width for a relative change of one number of one side.
double by_hand(double (Straight::*member)[2], int side, double tau, double g) {
    const double h = 1e-5;
    Straight more, less;
    (more.*member)[side] *= 1.0 + h;
    (less.*member)[side] *= 1.0 - h;
    return (more.width(tau, g) - less.width(tau, g)) / (2.0 * h);
}

TEST(Robust, LinearSpringsAreKnownByHand) {
    const DrawnJoint drawn = linear();
    const double g = drawn.actuator.ratio(), tau = 1.0;
    const RobustBand band = robust_dead_band(drawn, tau, {.rate_se = 0.04, .rate_pe = 0.05, .contour = 0.0, .friction = 0.06});
    EXPECT_NEAR(band.nominal, Straight().width(tau, g), 1e-9);
    // A rate's error multiplies the whole torque, which for straight lines is the stiffness. Differences by h^2 = 1e-10.
    const auto sigma = [&](double(Straight::*member)[2], double each) {
        return each * std::hypot(by_hand(member, 0, tau, g), by_hand(member, 1, tau, g));
    };
    EXPECT_NEAR(band.sources[0], sigma(&Straight::s, 0.04), 1e-8);
    EXPECT_NEAR(band.sources[1], sigma(&Straight::p, 0.05), 1e-8);
    EXPECT_NEAR(band.sources[3], sigma(&Straight::mu, 0.06), 1e-8);
    EXPECT_EQ(band.sources[2], 0.0);
    EXPECT_NEAR(band.sigma, std::hypot(band.sources[0], band.sources[1], band.sources[3]), 1e-15);
    EXPECT_NEAR(std::log(band.band.high / band.nominal), 1.645 * band.sigma / band.nominal, 1e-3 * band.sigma);
    EXPECT_NEAR(band.band.high * band.band.low, band.nominal * band.nominal, 1e-14);
    EXPECT_NEAR(band.covered_share, 1.0, 1e-6);
}

TEST(Robust, NoScatterLeavesNoBand) {
    const ShopScatter none{.rate_se = 0.0, .rate_pe = 0.0, .contour = 0.0, .friction = 0.0};
    for (const double tau : {1.0, 1.5}) {
        const double nominal = actuator::dead_band(paper().actuator, tau).exact_width;
        const RobustBand band = robust_dead_band(paper(), tau, none);
        EXPECT_NEAR(band.nominal, nominal, 1e-8);  // the equilibrium's residual
        EXPECT_EQ(band.sigma, 0.0);
        EXPECT_EQ(band.band.low, band.nominal);
        EXPECT_EQ(band.band.high, band.nominal);
        EXPECT_EQ(band.covered_share, 1.0);
        const SampledBand sampled = sample_dead_band(paper(), tau, none, {.count = 20});
        EXPECT_NEAR(sampled.mean, nominal, 1e-8);
        EXPECT_NEAR(sampled.band.width(), 0.0, 1e-12);
        EXPECT_EQ(sampled.covered_share, 1.0);
    }
}

/// Dead-band of the paper's actuator with one error on side 1, built and solved whole.
double built_width(const DrawnJoint& drawn, double tau, const spring::BuildError& se, const spring::BuildError& pe, double mu) {
    const actuator::Actuator& rig = drawn.actuator;
    const auto series = spring::series_spring(rig.law), parallel = spring::parallel_spring(rig.law);
    const auto joint =
        actuator::antagonist(spring::make_built_spring(parallel, drawn.base_pe, rig.capstan_radius, pe),
                             spring::make_built_spring(series, drawn.base_se, rig.capstan_radius, se), series, parallel,
                             {spring::FrictionLaw::proportional(mu), rig.gear_friction}, rig.capstan_radius, rig.joint_radius);
    return actuator::joint_dead_band(joint, tau, tau).exact_width;
}

// The derivatives are exact: the same as differences of actuators built with one error, for each kind of error.
TEST(Robust, DerivativesAreThoseOfBuiltActuators) {
    const DrawnJoint drawn = paper();
    for (const double tau : {1.0, 1.5}) {
        const double h = 1e-4, dr = 1e-6;
        const auto by = [&](const spring::BuildError& se, const spring::BuildError& pe, double mu) {
            const double more = built_width(drawn, tau, se, pe, kMu * (1.0 + mu));
            const double less = built_width(drawn, tau, {.rate = -se.rate, .radius = -se.radius, .preload = 0.0},
                                            {.rate = -pe.rate, .radius = -pe.radius, .preload = 0.0}, kMu * (1.0 - mu));
            return 0.5 * (more - less);
        };
        // By symmetry each side moves the width equally, so a source's sigma is sqrt(2) times one side's.
        const auto near = [&](double source, double difference, double step) {
            EXPECT_NEAR(source, std::sqrt(2.0) * std::abs(difference) / step, 1e-5 * source) << tau;
        };
        near(robust_dead_band(drawn, tau, {1.0 / 16, 0.0, 0.0, 0.0}).sources[0], by({.rate = h}, {}, 0.0), 16 * h);
        near(robust_dead_band(drawn, tau, {0.0, 1.0 / 16, 0.0, 0.0}).sources[1], by({}, {.rate = h}, 0.0), 16 * h);
        near(robust_dead_band(drawn, tau, {0.0, 0.0, 0.0, 1.0 / 16}).sources[3], by({}, {}, h), 16 * h);
        const double both = std::hypot(by({.radius = dr}, {}, 0.0), by({}, {.radius = dr}, 0.0));
        near(robust_dead_band(drawn, tau, {0.0, 0.0, 1e-4, 0.0}).sources[2], both, 1e-2);
    }
}

// 2000 actuators: the sampled sigma errs by sigma/sqrt(2 * 2000) = 1.6 %, a 5 or 95 % point by 0.047 sigma. Beyond three times that, what
// is left for the second order: 3 % of sigma, and 0.05 sigma of a percentile (measured 1 % and 0.05).
TEST(Robust, FirstOrderAgreesWithMonteCarlo) {
    for (const double tau : {1.0, 1.5}) {
        const RobustBand first = robust_dead_band(paper(), tau);
        const SampledBand sampled = sample_dead_band(paper(), tau, {}, {.count = 2000, .seed = 7});
        EXPECT_NEAR(sampled.sigma, first.sigma, 0.08 * first.sigma) << tau;
        EXPECT_NEAR(sampled.mean, first.nominal, 0.12 * first.sigma) << tau;
        EXPECT_NEAR(sampled.band.low, first.band.low, 0.19 * first.sigma) << tau;
        EXPECT_NEAR(sampled.band.high, first.band.high, 0.19 * first.sigma) << tau;
        EXPECT_GT(sampled.covered_share, 0.995) << tau;
        EXPECT_NEAR(sampled.covered_share, first.covered_share, 0.005) << tau;
    }
}

// Springs that end just beyond the drawn edge: half of what is built does not get there, on either side.
TEST(Robust, SaysWhatShareReachesItsEdges) {
    double earlier = 0.0;
    for (const double end : {2.21, 2.3, 2.4}) {
        const RobustBand first = robust_dead_band(paper(end), 1.5);
        const SampledBand sampled = sample_dead_band(paper(end), 1.5, {}, {.count = 400});
        // Both edges count as independent, which they are not quite: a little low. Three times the sampling error is 0.07.
        EXPECT_NEAR(first.covered_share, sampled.covered_share, 0.1) << end;
        EXPECT_GT(first.covered_share, earlier);
        earlier = first.covered_share;
    }
    const RobustBand ended = robust_dead_band(paper(2.1), 1.5);
    EXPECT_TRUE(std::isnan(ended.nominal));
    EXPECT_TRUE(std::isnan(ended.band.high));
    EXPECT_EQ(ended.covered_share, 0.0);
}

TEST(Robust, GearsWithConstantAndMeasuredFriction) {
    DrawnJoint drawn = paper();
    drawn.actuator.gear_friction = spring::FrictionLaw::affine(0.03, 0.24, 0.1);
    const RobustBand straight = robust_dead_band(drawn, 1.0);
    const SampledBand sampled = sample_dead_band(drawn, 1.0, {}, {.count = 1000});
    EXPECT_NEAR(sampled.sigma, straight.sigma, 0.1 * straight.sigma);  // three times 1/sqrt(2000), and the second order
    drawn.actuator.gear_friction = spring::FrictionLaw::tabulated({0.0, 1.0, 3.0}, {0.033, 0.297, 0.825});
    EXPECT_NEAR(robust_dead_band(drawn, 1.0).sigma, straight.sigma, 1e-9);
}

TEST(RobustRefusal, BadInputIsNamed) {
    const auto field = [](const auto& spoil, double tau = 1.0) {
        DrawnJoint drawn = paper();
        ShopScatter scatter;
        spoil(drawn, scatter);
        return field_refused([&] { return robust_dead_band(drawn, tau, scatter); });
    };
    EXPECT_EQ(field([](DrawnJoint&, ShopScatter& s) { s.rate_se = -0.1; }), "scatter.rate_se");
    EXPECT_EQ(field([](DrawnJoint&, ShopScatter& s) { s.rate_pe = 0.5; }), "scatter.rate_pe");
    EXPECT_EQ(field([](DrawnJoint&, ShopScatter& s) { s.contour = std::nan(""); }), "scatter.contour");
    EXPECT_EQ(field([](DrawnJoint&, ShopScatter& s) { s.friction = 1.0; }), "scatter.friction");
    EXPECT_EQ(field([](DrawnJoint& d, ShopScatter&) { d.base_pe.rate = 0.0; }), "base_pe.rate");
    EXPECT_EQ(field([](DrawnJoint& d, ShopScatter&) { d.base_se.preload = 0.0; }), "base_se.preload");
    EXPECT_EQ(field([](DrawnJoint& d, ShopScatter&) { d.actuator.law = nullptr; }), "law");
    EXPECT_EQ(field([](DrawnJoint&, ShopScatter&) {}, -1.0), "tau");
}

}  // namespace
}  // namespace fusee::design
