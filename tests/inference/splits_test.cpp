#include "fusee/inference/splits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "inference/fixture.h"

namespace fusee::inference {
namespace {

using namespace fixtures;

TEST(Folds, KeepSetPointsAndStretchesTogetherAndFillEveryFold) {
    gap_case::Rows rows = pulls(1);
    rows.breakaway = break_aways({0.2, 0.5, 0.8, 1.1}, 3, true).breakaway;
    const gap_case::Case gap_case = measured_case(rows, {}, {}, 0.0, 1);
    const std::vector<int> fold = folds(JointProblem(gap_case));
    ASSERT_EQ(fold.size(), gap_case.rows.size());
    std::map<double, std::set<int>> of_torque;
    for (std::size_t i = 0; i < gap_case.rows.breakaway.size(); ++i) of_torque[gap_case.rows.breakaway[i].motor_torque].insert(fold[i]);
    std::set<int> all;
    for (const auto& [torque, folds] : of_torque) {
        EXPECT_EQ(folds.size(), 1U) << torque;
        all.insert(*folds.begin());
    }
    EXPECT_EQ(all.size(), static_cast<std::size_t>(kFolds));
}

TEST(Folds, HoldOutWholeStrokesOfSpringsAndQuartersOfALog) {
    gap_case::Rows rows = pulls(1);
    rows.log = short_log(2.0).log;
    const gap_case::Case gap_case = measured_case(rows, {}, {}, 0.0, 1);
    const JointProblem problem(gap_case);
    const std::vector<int> fold = folds(problem);
    std::map<std::tuple<bool, gap_case::Side, bool>, std::set<int>> of_stroke;
    for (std::size_t i = 0; i < rows.spring_pull.size(); ++i) {
        const gap_case::SpringPull& row = rows.spring_pull[i];
        of_stroke[{row.series, row.side, row.load}].insert(fold[i]);
    }
    EXPECT_EQ(of_stroke.size(), 8U);
    for (const auto& [stroke, folds] : of_stroke) EXPECT_EQ(folds.size(), 1U);
    for (const bool series : {true, false})
        EXPECT_NE(of_stroke.at({series, gap_case::Side::kAgonist, true}), of_stroke.at({series, gap_case::Side::kAgonist, false}))
            << "the other stroke is seen";
    const std::vector<int> log(fold.begin() + static_cast<std::ptrdiff_t>(rows.spring_pull.size()), fold.end());
    EXPECT_TRUE(std::is_sorted(log.begin(), log.end())) << "one quarter after the other";
    EXPECT_EQ(std::set<int>(log.begin(), log.end()).size(), static_cast<std::size_t>(kFolds));
    EXPECT_EQ(problem.experiments()[1].blocks, "strokes");
    EXPECT_EQ(problem.experiments()[1].unit, "Nm");
    EXPECT_EQ(problem.experiments()[5].unit, "rad");
}

TEST(Folds, AStrokeThatIsAloneIsHeldOutInStretches) {
    gap_case::Rows rows = pulls(1);
    std::erase_if(rows.spring_pull, [](const auto& row) { return !row.series || !row.load || row.side != gap_case::Side::kAgonist; });
    const gap_case::Case gap_case = measured_case(rows, {}, {}, 0.0, 1);
    const JointProblem problem(gap_case);
    EXPECT_EQ(problem.experiments()[1].blocks, "stretches");
    const std::vector<int> fold = folds(problem);
    EXPECT_EQ(std::set<int>(fold.begin(), fold.end()).size(), static_cast<std::size_t>(kFolds));
}

TEST(Folds, OfALogWhoseSecondPartCountsTimeFromAnew) {
    gap_case::Rows rows = short_log(2.0);
    for (gap_case::LogRow& row : rows.log) row.time += 30.0;
    const std::vector<gap_case::LogRow> again = short_log(2.0).log;
    rows.log.insert(rows.log.end(), again.begin(), again.end());
    rows.parts[gap_case::Experiment::kLog] = {again.size(), again.size()};
    const gap_case::Case gap_case = measured_case(rows, {}, {}, 0.0, 1);
    for (const int fold : folds(JointProblem(gap_case))) EXPECT_TRUE(fold >= 0 && fold < kFolds) << fold;
}

TEST(HeldOut, RowsThatNoRefitSawArePredictedAsWellAsThoseThatItSaw) {
    gap_case::Rows rows = pulls(3);
    rows.breakaway = break_aways({0.2, 0.5, 0.8, 1.1}, 3, true).breakaway;
    const gap_case::Case gap_case = measured_case(rows, {{"gear.coulomb", "agonist"}}, {0.06}, 1.0, 7);
    const JointProblem problem(gap_case);
    const Fit found = best_fit(problem, {{"gear.coulomb", "agonist"}});
    const Fit null = best_fit(problem, {});
    const Split split = held_out(problem, null, found, 1);
    EXPECT_EQ(split.x.size(), static_cast<std::size_t>(kFolds));
    const double seen = found.residual.norm(), unseen = split.residual.norm();
    EXPECT_GT(unseen, seen);
    EXPECT_LT(unseen, 1.3 * seen);  // one figure from 12 rows, three quarters of them kept
    const Split four = held_out(problem, null, found, 4);
    EXPECT_EQ(four.residual, split.residual);
}

/// Break-aways and pulls of a rig with Coulomb friction on one side.
gap_case::Case with_friction(unsigned seed) {
    gap_case::Rows rows = pulls(3);
    rows.breakaway = break_aways({0.2, 0.5, 0.8, 1.1}, 3, true).breakaway;
    return measured_case(rows, {kCoulomb}, {0.06}, 1.0, seed);
}

TEST(HeldOut, WhatTheRowsOfAFoldSayDoesNotReachItsRefit) {
    const gap_case::Case honest = with_friction(7);
    gap_case::Case spoilt = honest;
    const std::vector<int> fold = folds(JointProblem(honest));
    for (std::size_t i = 0; i < honest.rows.breakaway.size(); ++i)
        if (fold[i] == 0) spoilt.rows.breakaway[i].load_torque *= 0.7;
    const auto refit_of = [](const gap_case::Case& gap_case) {
        const JointProblem problem(gap_case);
        return held_out(problem, best_fit(problem, {}), best_fit(problem, {kCoulomb}), 1);
    };
    const Split a = refit_of(honest), b = refit_of(spoilt);
    for (Eigen::Index k = 0; k < a.x[0].size(); ++k) EXPECT_NEAR(a.x[0][k], b.x[0][k], 0.1 * a.sigma[0][k]) << k;
    EXPECT_GT((a.x[1] - b.x[1]).cwiseQuotient(a.sigma[1]).cwiseAbs().maxCoeff(), 0.5);  // the other refits have these rows
}

TEST(HeldOut, TheExpectedResidualIsThatOfManyCases) {
    double measured = 0.0, expected = 0.0;
    for (unsigned seed = 1; seed <= 8; ++seed) {
        const gap_case::Case gap_case = with_friction(seed);
        const JointProblem problem(gap_case);
        const Split split = held_out(problem, best_fit(problem, {}), best_fit(problem, {kCoulomb}), 1);
        measured += split.residual.squaredNorm();
        expected += split.expected.squaredNorm();
    }
    EXPECT_NEAR(std::sqrt(measured / expected), 1.0, 0.1);
}

}  // namespace
}  // namespace fusee::inference
