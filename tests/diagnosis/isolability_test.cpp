#include "isolability.h"

#include <gtest/gtest.h>

#include "inference/fixture.h"

namespace fusee::diagnosis {
namespace {

using namespace fixtures;

/// Isolability of `causes` on a faultless rig without noise.
Isolability of(const gap_case::Rows& rows, const std::vector<effects::Cause>& causes, unsigned jobs = 1) {
    const gap_case::Case gap_case = measured_case(rows, {}, {}, 0.0, 1);
    const JointProblem problem(gap_case);
    return isolability(problem, best_fit(problem, {}), causes, jobs);
}

TEST(Isolability, OneLoadCannotTellConstantFromLoadFrictionAndSixCan) {
    const std::vector<effects::Cause> causes{kCoulomb, kOtherCoulomb, kLoad};
    const Isolability one = of(break_aways({0.8}, 4, false), causes);
    EXPECT_NEAR(one.signature_similarity[0][2], 1.0, 1e-6);  // one figure: both only move it
    EXPECT_EQ(one.classes, (std::vector<std::vector<std::size_t>>{{0, 2}}));
    const Isolability six = of(break_aways({0.1, 0.4, 0.7, 1.0, 1.3, 1.5}, 4, true), causes);
    EXPECT_LT(six.signature_similarity[0][2], 0.8);
    EXPECT_TRUE(six.classes.empty());
}

TEST(Isolability, LeastSizeIsThreeSigmaOfTheMeanBesideTheTolerances) {
    const int repeats = 4;
    const double torque = 0.8;
    const gap_case::Case gap_case = measured_case(break_aways({torque}, repeats, false), {}, {}, 0.0, 1);
    const JointProblem problem(gap_case);
    const Isolability found = isolability(problem, best_fit(problem, {}), {kCoulomb}, 1);
    // load = (tau + c)/(1 - mu): dload/dc = 1/(1 - mu), dload/dmu = tau/(1 - mu)^2, dload/dscale = tau/(1 - mu)
    const double mu = gap_case.rig.gear_load_friction, lever = 1.0 - mu;
    const double sigma = problem.experiments()[place_of(gap_case::Experiment::kBreakAway)].sigma.front();
    const double weight = problem.experiments()[place_of(gap_case::Experiment::kBreakAway)].weight;
    const double by_mu = torque / (lever * lever) * mu * gap_case.tolerance.gear_load_friction;
    const double by_scale = torque / lever * gap_case.tolerance.torque_scale;
    const double mean = std::sqrt(sigma * sigma / (weight * repeats) + by_mu * by_mu + by_scale * by_scale);
    EXPECT_NEAR(found.detectable[0] / (3.0 * lever * mean), 1.0, 0.01);  // 1 %: slopes are differences over 0.3 sigma
    EXPECT_EQ(found.units[0], "Nm");
}

TEST(Isolability, APullTellsSidesAndSpringsApartAndIsBlindForFriction) {
    const Isolability found = of(pulls(5), {kRate, kOtherRate, {"pe.rate", "agonist"}, kCoulomb});
    EXPECT_LT(found.signature_similarity[0][1], 1e-9);  // the sides have no build parameter in common that a pull sees
    EXPECT_LT(found.signature_similarity[0][2], 0.1);
    EXPECT_EQ(found.signature_similarity[0][3], 0.0);
    EXPECT_TRUE(std::isnan(found.detectable[3]));
    EXPECT_LT(found.detectable[0], 0.12);  // the usual size
    EXPECT_TRUE(found.classes.empty());
}

TEST(Isolability, ALogTellsTheDragsApart) {
    const Isolability found = of(short_log(1.5), {kDrag, kJointDrag});
    EXPECT_LT(found.signature_similarity[0][1], 0.95);
    EXPECT_TRUE(found.classes.empty());
    EXPECT_LT(found.detectable[0], 0.05);  // the usual sizes
    EXPECT_LT(found.detectable[1], 0.04);
}

TEST(Isolability, StraightSpringsHideAStretchedCableBehindASoftSpring) {
    // F = k x/(1 + k c) is a straight spring of another rate: no pull can tell
    const Isolability found = of(pulls(5), {kRate, kStretch, kOtherRate});
    EXPECT_GT(found.signature_similarity[0][1], 0.99);
    ASSERT_EQ(found.classes.size(), 1U);
    EXPECT_EQ(found.classes[0], (std::vector<std::size_t>{0, 1}));
}

TEST(Isolability, ALimitIsSeenUpToWhereTheRigComes) {
    gap_case::Rows rows;
    const gap_case::CaseTemplate t = small_template();
    for (const gap_case::DeadBandRow& row : set_points(t).dead_band)
        if (row.repeat == 1 && row.cocontraction > 0.5 && row.cocontraction < 1.0) rows.dead_band.push_back(row);
    const gap_case::Case gap_case = measured_case(rows, {}, {}, 0.0, 1);
    const JointProblem problem(gap_case);
    const double most = isolability(problem, best_fit(problem, {}), {kStop}, 1).detectable[0];
    double reach = 0.0;
    for (const gap_case::DeadBandRow& row : gap_case.rows.dead_band) reach = std::max({reach, row.q_high, -row.q_low});
    EXPECT_GT(most, 0.8 * reach);  // a stop inside what is read cuts it
    EXPECT_LT(most, 4.0);          // and one that the push does not reach is none
}

TEST(Isolability, SymmetricBetween0And1AndTheSameForAnyThreads) {
    gap_case::Rows rows = pulls(5);
    rows.breakaway = break_aways({0.3, 0.9}, 2, true).breakaway;
    const std::vector<effects::Cause> causes{
        kCoulomb, kLoad, kOtherCoulomb, kRate, kStretch, {"se.radius", "both"}, {"motor.saturation", "agonist"}};
    const Isolability one = of(rows, causes, 1), four = of(rows, causes, 4);
    for (std::size_t i = 0; i < causes.size(); ++i) {
        EXPECT_EQ(one.signature_similarity[i][i], 1.0);
        for (std::size_t j = 0; j < causes.size(); ++j) {
            EXPECT_EQ(one.signature_similarity[i][j], one.signature_similarity[j][i]);
            EXPECT_TRUE(one.signature_similarity[i][j] >= 0.0 && one.signature_similarity[i][j] <= 1.0);
        }
    }
    EXPECT_EQ(one.signature_similarity, four.signature_similarity);
    EXPECT_EQ(one.detectable, four.detectable);
    EXPECT_EQ(one.classes, four.classes);
}

}  // namespace
}  // namespace fusee::diagnosis
