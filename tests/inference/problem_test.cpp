#include "fusee/inference/problem.h"

#include <gtest/gtest.h>

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
