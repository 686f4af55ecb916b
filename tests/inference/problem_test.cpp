#include "fusee/inference/problem.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "fusee/core/units.h"
#include "inference/fixture.h"

namespace fusee::inference {
namespace {

using namespace fixtures;

TEST(Problem, ARippleOfTheOppositeSignIsTheSameHalfATurnOn) {
    const gap_case::Case gap_case = small_case(short_log(0.5));
    const JointProblem problem(gap_case);
    const Causes causes{{"term.motor.ripple", "antagonist"}};
    const double of_phase = problem.effect("term.motor.ripple").parameters.back().scale;
    Eigen::VectorXd x = problem.start(causes);
    x.tail(3) << -0.7, 0.4, 1.0 / of_phase;
    const Eigen::VectorXd positive = problem.with_positive_ripples(causes, x);
    EXPECT_DOUBLE_EQ(positive[positive.size() - 3], 0.7);
    EXPECT_DOUBLE_EQ(positive[positive.size() - 2], 0.4);
    EXPECT_NEAR(positive[positive.size() - 1] * of_phase, 1.0 - core::kPi, 1e-12);
    const std::size_t log = place_of(gap_case::Experiment::kLog);
    const std::vector<double> one = problem.predict(causes, x)[log], other = problem.predict(causes, positive)[log];
    ASSERT_FALSE(one.empty());
    for (std::size_t i = 0; i < one.size(); ++i) EXPECT_NEAR(one[i], other[i], 1e-9);
    EXPECT_EQ(problem.with_positive_ripples(causes, positive), positive);
}

/// What a deviation of each build parameter changes is what its cause does at the size of that deviation.
TEST(Problem, ABuildParameterAndItsCauseAreOneFigure) {
    gap_case::Rows rows = short_log(0.5);
    rows.spring_pull = pulls(20).spring_pull;
    rows.breakaway = break_aways({0.3, 1.4}, 1, true).breakaway;
    const gap_case::Case gap_case = small_case(rows);
    const JointProblem problem(gap_case);
    const Outputs nominal = problem.predict({}, problem.start({}));
    for (std::size_t k = 0; k < problem.build().size(); ++k) {
        const BuildParameter& own = problem.build()[k];
        EXPECT_EQ(own.cause.id.empty(), !own.of_workshop || own.name.starts_with("capstan radius")) << own.name;
        if (own.cause.id.empty() || own.cause.id == "joint.coulomb") continue;  // the bearing's friction never falls below 0
        Eigen::VectorXd deviating = problem.start({}), x = problem.start({own.cause});
        deviating[static_cast<Eigen::Index>(k)] = 4.0;
        x[problem.effect_size_index({own.cause}, 0)] = 4.0 * own.sigma * own.cause_size / problem.effect(own.cause.id).parameters[0].scale;
        const Outputs by_build = problem.predict({}, deviating), by_cause = problem.predict({own.cause}, x);
        double changed = 0.0;
        for (std::size_t e = 0; e < nominal.size(); ++e)
            for (std::size_t i = 0; i < nominal[e].size(); ++i) {
                EXPECT_NEAR(by_build[e][i], by_cause[e][i], 1e-9) << own.name;
                changed = std::max(changed, std::abs(by_build[e][i] - nominal[e][i]));
            }
        EXPECT_GT(changed, 1e-6) << own.name;
    }
}

TEST(Problem, OtherEffectsKeepTheirSign) {
    const gap_case::Case gap_case = small_case(short_log(0.5));
    const JointProblem problem(gap_case);
    const Causes causes{{"gear.coulomb", "agonist"}};
    Eigen::VectorXd x = problem.start(causes);
    x[x.size() - 1] = -0.5;
    EXPECT_EQ(problem.with_positive_ripples(causes, x), x);
}

}  // namespace
}  // namespace fusee::inference
