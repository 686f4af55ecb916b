#include "fusee/inference/fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "inference/fixture.h"

namespace fusee::inference {
namespace {

using namespace fixtures;

// Some hypotheses make a rig run away. Ceres logs such points on stderr, where users would read them.
TEST(Fit, FromAPointWithoutPredictionSaysNothingOnStderr) {
    const gap_case::Case gap_case = measured_case(short_log(0.5), {}, {}, 1.0, 3);
    const JointProblem problem(gap_case);
    Eigen::VectorXd start = problem.start({});
    start[1] = 1e200;  // sigmas of a spring's rate
    testing::internal::CaptureStderr();
    const Fit found = fit(problem, {}, start);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_FALSE(std::isfinite(found.cost));
}

}  // namespace
}  // namespace fusee::inference
