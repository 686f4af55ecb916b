#include "fusee/inference/interval.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fusee/inference/constants.h"
#include "fusee/inference/search.h"
#include "inference/fixture.h"

namespace fusee::inference {
namespace {

using namespace fixtures;

/// A fit of one effect at `size` (in scales, sigma 0.01) and what refits without each of six experiments find.
struct Refitted {
    gap_case::Case gap_case = small_case(pulls(5));
    JointProblem problem{gap_case};
    Fit fit;
    Split left_out;
    int k = 0;

    Refitted(const effects::Cause& cause, double size, const std::vector<double>& without, const std::vector<double>& sigma) {
        fit.causes = {cause};
        k = problem.effect_size_index(fit.causes, 0);
        fit.x = Eigen::VectorXd::Zero(problem.dimension(fit.causes));
        fit.x[k] = size;
        fit.covariance = Eigen::MatrixXd::Identity(fit.x.size(), fit.x.size()) * 1e-4;
        for (std::size_t e = 0; e < without.size(); ++e) {
            left_out.x.push_back(fit.x);
            left_out.x.back()[k] = without[e];
            left_out.sigma.emplace_back(Eigen::VectorXd::Constant(fit.x.size(), sigma[e]));
        }
    }
    [[nodiscard]] bool stands() const { return contradicted(problem, fit, left_out).empty(); }
};
const std::vector<double> kSharp(6, 0.02);

TEST(Student95, IsThatOfTheTable) {
    EXPECT_NEAR(student95(4), 3.182, 5e-4);
    EXPECT_NEAR(student95(5), 2.776, 5e-4);
    EXPECT_NEAR(student95(6), 2.571, 5e-4);
    EXPECT_EQ(student95(1), student95(4));
}

TEST(HalfInterval, IsThatOfTheFitWhereNoRefitDiffers) {
    const Refitted same(kCoulomb, 1.0, std::vector<double>(6, 1.0), kSharp);
    EXPECT_NEAR(half_interval(same.fit, same.left_out, same.k), 1.959964 * std::hypot(0.01, 0.01), 1e-9);  // sigma and 1 % of the size
}

TEST(HalfInterval, GrowsWithTheSpreadOfTheRefits) {
    // Mean 1, sum of squares 6 * 0.01; (n - 1)/n of it is 0.05.
    const Refitted spread(kCoulomb, 1.0, {0.9, 1.1, 0.9, 1.1, 0.9, 1.1}, kSharp);
    EXPECT_NEAR(half_interval(spread.fit, spread.left_out, spread.k),
                std::hypot(1.959964 * std::hypot(0.01, 0.01), 2.570582 * std::sqrt(0.05)), 1e-6);
}

TEST(Contradicted, NotACauseThatEverySplitFinds) {
    EXPECT_TRUE(Refitted(kCoulomb, 1.0, {0.9, 1.1, 1.0, 1.0, 1.05, 0.95}, kSharp).stands());
}

TEST(Contradicted, ACauseThatTheOtherExperimentsSpeakAgainst) {
    EXPECT_FALSE(Refitted(kCoulomb, 1.0, {0.1, 1.1, 1.1, 1.1, 1.1, 1.1}, kSharp).stands());
}

TEST(Contradicted, NotACauseThatOneExperimentAloneCanSee) {
    EXPECT_TRUE(Refitted(kCoulomb, 1.0, {0.0, 1.0, 1.0, 1.0, 1.0, 1.0}, {2.9, 0.02, 0.02, 0.02, 0.02, 0.02}).stands());
}

// The rows of the first refit say 12 +- 2.8; with the prior of 0 +- 3 that is 6.4 +- 2.05.
TEST(Contradicted, NotALargeSizeByARefitThatThePriorDrawsTo0) {
    EXPECT_TRUE(Refitted(kCoulomb, 12.0, {6.4, 12.0, 12.0, 12.0, 12.0, 12.0}, {2.05, 0.2, 0.2, 0.2, 0.2, 0.2}).stands());
    EXPECT_FALSE(Refitted(kCoulomb, 12.0, {4.0, 12.0, 12.0, 12.0, 12.0, 12.0}, kSharp).stands());
}

TEST(Contradicted, NotByTwoExperimentsWhichHaveNoScatter) {
    EXPECT_TRUE(Refitted(kCoulomb, 1.0, {0.6, 1.5}, {0.02, 0.02}).stands());
    EXPECT_FALSE(Refitted(kCoulomb, 1.0, {0.1, 1.5, 1.5}, {0.02, 0.02, 0.02}).stands());
}

TEST(OddsAgainst, AnEffectOfTheOtherSideCostsLittleWhereItsSizeIsAnother) {
    const gap_case::Case gap_case = small_case(pulls(5));
    const JointProblem problem(gap_case);
    Fit fit;
    const auto odds = [&](const Causes& causes, double first, double second) {
        fit.causes = causes;
        fit.x = Eigen::VectorXd::Zero(problem.dimension(causes));
        if (!causes.empty()) fit.x[problem.effect_size_index(causes, 0)] = first;
        if (causes.size() > 1) fit.x[problem.effect_size_index(causes, 1)] = second;
        return odds_against(problem, fit);
    };
    const effects::Cause agonist{"gear.coulomb", "agonist"}, antagonist{"gear.coulomb", "antagonist"};
    EXPECT_EQ(odds({}, 0.0, 0.0), 0.0);
    EXPECT_EQ(odds({agonist}, 1.0, 0.0), kEffectOdds);
    EXPECT_EQ(odds({agonist, antagonist}, 1.0, 0.4), kEffectOdds + kOtherSideOdds);
    EXPECT_EQ(odds({agonist, antagonist}, 1.0, 0.9), kEffectOdds + kSecondOdds) << "one effect of both sides";
    EXPECT_EQ(odds({agonist, {"se.rate", "antagonist"}}, 1.0, 0.4), kEffectOdds + kSecondOdds);
}

TEST(Contradicted, NotAStopWhoseAngleHasNoNothing) { EXPECT_TRUE(Refitted(kStop, 1.0, {0.1, 1.1, 1.1, 1.1, 1.1, 1.1}, kSharp).stands()); }

TEST(AtBounds, ASizeThatWantsToBeMoreThanItsLawAllows) {
    Refitted coulomb(kCoulomb, 1.0, std::vector<double>(6, 1.0), kSharp);
    EXPECT_TRUE(at_bounds(coulomb.problem, coulomb.fit).empty());
    coulomb.fit.x[coulomb.k] = coulomb.problem.allowed(coulomb.fit.causes, coulomb.k).high;
    EXPECT_EQ(at_bounds(coulomb.problem, coulomb.fit), coulomb.fit.causes);
    Refitted stop(kStop, 1.0, std::vector<double>(6, 1.0), kSharp);
    stop.fit.x[stop.k] = stop.problem.allowed(stop.fit.causes, stop.k).high;  // a stop that is never reached
    EXPECT_EQ(at_bounds(stop.problem, stop.fit), stop.fit.causes);
}

TEST(DiscountUnfounded, PairsNeedASingleEffectThatBeatsNone) {
    const std::vector<std::size_t> effects{2, 0, 1, 2};
    std::vector<double> founded{9.0, 0.0, 1.0, -2.0}, unfounded{9.0, 0.0, -1.0, -2.0};
    discount_unfounded(effects, founded);
    EXPECT_EQ(founded, (std::vector<double>{9.0, 0.0, 1.0, -2.0}));
    discount_unfounded(effects, unfounded);
    EXPECT_EQ(unfounded, (std::vector<double>{-21.0, 0.0, -1.0, -32.0}));
}

TEST(ExperimentsLeftOut, SayHowWellTheOthersSeeASize) {
    // Friction alone shows in break-away; without it pulls of springs know as little as the prior, three scales.
    gap_case::Rows rows = pulls(5);
    rows.breakaway = break_aways({0.2, 0.6, 1.0, 1.4}, 3, true).breakaway;
    const gap_case::Case gap_case = measured_case(rows, {kCoulomb}, {0.06}, 1.0, 4);
    const JointProblem problem(gap_case);
    const Fit fit = best_fit(problem, {kCoulomb});
    const Split left_out = experiments_left_out(problem, best_fit(problem, {}), fit, 1);
    const int k = problem.effect_size_index(fit.causes, 0);
    const auto of = [&](gap_case::Experiment e) { return left_out.sigma[static_cast<std::size_t>(e)][k]; };
    EXPECT_NEAR(of(gap_case::Experiment::kBreakAway), 3.0, 1e-6);
    EXPECT_LT(of(gap_case::Experiment::kSpringPull), 0.1);
    EXPECT_TRUE(contradicted(problem, fit, left_out).empty());
}

}  // namespace
}  // namespace fusee::inference
