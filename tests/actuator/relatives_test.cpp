#include "fusee/actuator/relatives.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fusee/actuator/dead_band.h"
#include "fusee/spring/laws.h"
#include "fusee/spring/potential.h"
#include "refused.h"
#include "with_law.h"

namespace fusee::actuator {
namespace {

constexpr double kG = 1.5;
constexpr core::Range kLevels{0.4, 1.6};

constexpr Arrangement kAll[] = {Arrangement::kPnrvsa,          Arrangement::kSeriesElastic, Arrangement::kSimpleAntagonist,
                                Arrangement::kQuasiAntagonist, Arrangement::kBidirectional, Arrangement::kCrossCoupled};

ArrangementOptions options(Arrangement arrangement, spring::PotentialPtr series, spring::PotentialPtr parallel = nullptr) {
    return {.arrangement = arrangement,
            .series = std::move(series),
            .parallel = std::move(parallel),
            .gear_friction = spring::FrictionLaw::proportional(kMu),
            .capstan_radius = 0.03,
            .joint_radius = 0.03 * kG};
}

/// F = c x^2, so S = 2 sqrt(c F).
constexpr double kC = 0.3;
spring::PotentialPtr quadratic(double c = kC) { return spring::make_polynomial({0.0, 0.0, c}); }
double quadratic_stiffness(double force) { return 2.0 * std::sqrt(kC * force); }

ArrangementOptions with_loops(ArrangementOptions options, double stiffness) {
    options.position_stiffness = stiffness;
    return options;
}

TEST(Relatives, NamesAreStable) {
    const char* const names[] = {"pnrvsa", "series_elastic", "simple_antagonist", "quasi_antagonist", "bidirectional", "cross_coupled"};
    for (std::size_t i = 0; i < std::size(kAll); ++i) EXPECT_STREQ(to_string(kAll[i]), names[i]);
}

TEST(Relatives, ThePapersJointHasItsOwnDeadBand) {
    const auto law = *spring::make_stiction_law({.k = 0.225, .u = 0.0012, .c = 0.265, .mu = kMu, .start_torque = 0.6, .end_torque = 2.4});
    const ArrangementRow row = survey(options(Arrangement::kPnrvsa, spring::series_spring(law), spring::parallel_spring(law)), {1.0, 1.5});
    const Actuator actuator{.law = law,
                            .capstan_radius = 0.03,
                            .joint_radius = 0.03 * kG,
                            .gear_friction = spring::FrictionLaw::proportional(kMu),
                            .least_torque = 1.0,
                            .peak_torque = 1.5,
                            .overdrive_torque = 1.5};
    const DeadBand low = dead_band(actuator, 1.0), high = dead_band(actuator, 1.5);
    // The equilibrium's residual, 1e-9 relative, passes through the stiffness.
    EXPECT_NEAR(row.stiffness.low, low.joint_stiffness, 1e-8);
    EXPECT_NEAR(row.stiffness.high, high.joint_stiffness, 1e-8);
    EXPECT_NEAR(row.free_stiffness.low, low.free_joint_stiffness, 1e-8);
    EXPECT_NEAR(row.free_stiffness.high, high.free_joint_stiffness, 1e-8);
    EXPECT_NEAR(row.dead_band.low, low.linear, 1e-8);
    EXPECT_NEAR(row.dead_band.high, high.linear, 1e-8);
    EXPECT_NEAR(row.torque, kG * (law->at_load(1.5).f_se - law->at_load(1.0).f_se), 1e-9);
}

// Held gears: every spring of F = c x^2 stands at the level's torque.
TEST(Relatives, QuadraticSpringsAreKnownByHand) {
    struct {
        Arrangement arrangement;
        double springs;  ///< that resist the joint side by side
        double torque;   ///< over g
    } const known[] = {{Arrangement::kSeriesElastic, 1.0, kLevels.high},
                       {Arrangement::kSimpleAntagonist, 2.0, kLevels.width()},
                       {Arrangement::kQuasiAntagonist, 2.0, kLevels.width()},
                       {Arrangement::kBidirectional, 2.0, 2.0 * kLevels.high},
                       {Arrangement::kCrossCoupled, 2.0, kLevels.width()}};
    for (const auto& [arrangement, springs, torque] : known) {
        const ArrangementRow row = survey(options(arrangement, quadratic()), kLevels);
        EXPECT_NEAR(row.stiffness.low, springs * kG * kG * quadratic_stiffness(kLevels.low), 1e-8) << to_string(arrangement);
        EXPECT_NEAR(row.stiffness.high, springs * kG * kG * quadratic_stiffness(kLevels.high), 1e-8) << to_string(arrangement);
        EXPECT_NEAR(row.torque, kG * torque, 1e-8) << to_string(arrangement);
    }
}

// The paper's point: under torque control only its own arrangement is held by anything.
TEST(Relatives, TorqueControlLeavesAllButThePapersNeutral) {
    for (const Arrangement arrangement : kAll) {
        ArrangementOptions all = options(arrangement, quadratic(), spring::make_polynomial({0.0, 0.4, 0.1}));
        all.cross_stretch = 8.0;  // the motors pay the cross spring out by 2 theta
        const ArrangementRow row = survey(all, kLevels);
        const bool grounded = arrangement == Arrangement::kPnrvsa;
        EXPECT_EQ(row.free_stiffness.high > 0.0, grounded) << to_string(arrangement);
        EXPECT_EQ(std::isinf(row.dead_band.low), !grounded) << to_string(arrangement);
        EXPECT_EQ(row.remark.find("a = b = 0") == std::string::npos, grounded) << to_string(arrangement);
    }
}

// A loop of stiffness k at each motor does in a simple antagonist what a linear K_PE does in the paper's joint.
TEST(Relatives, PositionLoopsActAsLinearParallelSprings) {
    const double k = 0.7, s = quadratic_stiffness(kLevels.low), tau_f = kMu * kLevels.low;
    for (const Arrangement arrangement : {Arrangement::kSimpleAntagonist, Arrangement::kBidirectional, Arrangement::kCrossCoupled}) {
        const ArrangementRow row = survey(with_loops(options(arrangement, quadratic()), k), kLevels);
        EXPECT_NEAR(row.free_stiffness.low, 2.0 * kG * kG * s * k / (s + k), 1e-8) << to_string(arrangement);
        EXPECT_NEAR(row.dead_band.low, 2.0 * tau_f / (kG * k), 1e-8) << to_string(arrangement);
    }
    const ArrangementRow single = survey(with_loops(options(Arrangement::kSeriesElastic, quadratic()), k), kLevels);
    EXPECT_NEAR(single.free_stiffness.low, kG * kG * s * k / (s + k), 1e-8);
    EXPECT_NEAR(single.dead_band.low, 2.0 * tau_f / (kG * k), 1e-8);
    // The drive of a quasi-antagonist is unloaded at rest; q = theta_2/(2 g) follows the other motor alone, against k + S/2.
    const ArrangementRow quasi = survey(with_loops(options(Arrangement::kQuasiAntagonist, quadratic()), k), kLevels);
    EXPECT_NEAR(quasi.dead_band.low, 2.0 * tau_f / (kG * (2.0 * k + s)), 1e-8);
}

TEST(Relatives, SimpleAntagonistIsThePapersJointWithoutParallelSprings) {
    const ArrangementRow simple = survey(options(Arrangement::kSimpleAntagonist, quadratic()), kLevels);
    double earlier = 0.0;
    for (const double p : {1e-2, 1e-4, 1e-6}) {
        const ArrangementRow paper = survey(options(Arrangement::kPnrvsa, quadratic(), spring::make_polynomial({0.0, p})), kLevels);
        // K_PE carries p theta of the level, and leaves 2 g^2 p of free stiffness: both of order p, theta below 3 rad.
        EXPECT_NEAR(paper.stiffness.high, simple.stiffness.high, 20.0 * p);
        EXPECT_NEAR(paper.free_stiffness.high, simple.free_stiffness.high, 5.0 * p);
        EXPECT_GT(paper.dead_band.low, 50.0 * earlier);  // on its way to infinity as 1/p
        earlier = paper.dead_band.low;
    }
}

TEST(Relatives, CrossCoupledWithoutCrossSpringIsTheSimpleAntagonist) {
    const Joint cross = make_arrangement(options(Arrangement::kCrossCoupled, quadratic()));
    const Joint simple = make_arrangement(options(Arrangement::kSimpleAntagonist, quadratic()));
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> angle(-2.0, 4.0);
    for (int i = 0; i < 100; ++i) {
        const Eigen::Vector3d z(angle(random), angle(random), angle(random));
        EXPECT_EQ(energy(cross, z), energy(simple, z));
        EXPECT_EQ(spring_torques(cross, z), spring_torques(simple, z));
        EXPECT_EQ(stiffness(cross, z), stiffness(simple, z));
    }
}

// Linear springs s and c: s theta - c (stretch - 2 theta) = level, so winding in pays the cross spring out.
TEST(Relatives, CrossSpringHelpsTheMotorsWindIn) {
    const double s = 0.8, c = 0.2;
    const auto crossed = options(Arrangement::kCrossCoupled, spring::make_polynomial({0.0, s}), spring::make_polynomial({0.0, c}));
    ArrangementOptions tense = crossed;
    tense.cross_stretch = 6.0;
    const ArrangementRow row = survey(tense, kLevels);
    EXPECT_NEAR(row.torque, kG * s * kLevels.width() / (s + 2.0 * c), 1e-8);
    EXPECT_NEAR(row.stiffness.high, 2.0 * kG * kG * s, 1e-8);
    const ArrangementRow looped = survey(with_loops(tense, 0.5), kLevels);
    EXPECT_NEAR(looped.dead_band.low, 2.0 * kMu * kLevels.low / (kG * 0.5), 1e-8);  // c couples only the motion that leaves q alone
}

TEST(Relatives, SpringsThatPullAndPushAreOdd) {
    const auto preloaded = spring::make_polynomial({0.2, 0.5, 0.1});
    const Joint joint = make_arrangement(options(Arrangement::kSeriesElastic, preloaded));
    const auto at = [](double x) { return Eigen::Vector3d(x, 0.0, 0.0); };
    for (const double x : {1e-6, 5e-5, 1e-3, 0.4, 3.0}) {
        EXPECT_EQ(spring_torques(joint, at(-x))(0), -spring_torques(joint, at(x))(0));
        EXPECT_EQ(energy(joint, at(-x)), energy(joint, at(x)));
        const double h = 1e-7;
        EXPECT_NEAR((energy(joint, at(x + h)) - energy(joint, at(x - h))) / (2.0 * h), spring_torques(joint, at(x))(0), 1e-8) << x;
    }
    EXPECT_NEAR(spring_torques(joint, at(2.0))(0), preloaded->force(2.0), 1e-15);
    EXPECT_EQ(joint.springs.front().potential->domain().low, -100.0);
    EXPECT_TRUE(joint.frozen[kAntagonist]);
}

TEST(RelativesRefusal, BadOptionsAreNamed) {
    const auto field = [](const ArrangementOptions& options, core::Range levels = kLevels) {
        return field_refused([&] { return survey(options, levels); });
    };
    EXPECT_EQ(field(options(Arrangement::kSimpleAntagonist, nullptr)), "series");
    EXPECT_EQ(field(options(Arrangement::kPnrvsa, quadratic())), "parallel");
    ArrangementOptions broken = options(Arrangement::kSeriesElastic, quadratic());
    broken.position_stiffness = -1.0;
    EXPECT_EQ(field(broken), "position_stiffness");
    broken = options(Arrangement::kSeriesElastic, quadratic());
    broken.joint_radius = 0.0;
    EXPECT_EQ(field(broken), "joint_radius");
    EXPECT_EQ(field(options(Arrangement::kSeriesElastic, quadratic()), {0.0, 1.0}), "cocontraction.low");
    EXPECT_EQ(field(options(Arrangement::kSeriesElastic, quadratic()), {1.0, 0.5}), "cocontraction.high");
    // A cross spring that the motors pay out altogether.
    EXPECT_EQ(field(options(Arrangement::kCrossCoupled, quadratic(), quadratic())), "cocontraction");
    // K_SE of the paper's law ends near 0.6 Nm; alone it cannot carry 1.5 Nm of motor torque.
    const auto law = *spring::make_stiction_law({.k = 0.225, .u = 0.0012, .c = 0.265, .mu = kMu, .start_torque = 0.6, .end_torque = 2.4});
    EXPECT_EQ(field(options(Arrangement::kSimpleAntagonist, spring::series_spring(law)), {0.3, 1.5}), "cocontraction");
}

}  // namespace
}  // namespace fusee::actuator
