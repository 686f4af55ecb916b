#include "fusee/inference/model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fusee/core/error.h"
#include "fusee/inference/search.h"
#include "inference/pendulum.h"

// The engine on a model that is no joint: known answers.
namespace fusee::inference {
namespace {

using fixtures::Pendulum;

const Cause kDragged{"pivot.drag"}, kTurned{"encoder.offset"}, kHollow{"bob.hollow"};

TEST(Model, AFitFindsTheSizeThatWasPutInAndTheFigureWithinItsTolerance) {
    const Pendulum pendulum(0.08, 0.0, 0.004, 1);
    const Problem problem(pendulum);
    const Fit found = fit(problem, {kDragged}, problem.start({kDragged}));
    EXPECT_NEAR(found.x[0] * Pendulum::kLengthSigma, 0.004, 4.0 * std::sqrt(found.covariance(0, 0)) * Pendulum::kLengthSigma);
    EXPECT_NEAR(found.x[1] * Pendulum::kDragScale, 0.08, 4.0 * std::sqrt(found.covariance(1, 1)) * Pendulum::kDragScale);
    EXPECT_LT(std::sqrt(found.covariance(1, 1)) * Pendulum::kDragScale, 0.002);
    EXPECT_TRUE(explained(problem, found));
}

TEST(Model, ASearchNamesWhatWasPutIn) {
    const std::pair<std::array<double, 2>, Causes> cases[] = {
        {{0.0, 0.0}, {}}, {{0.1, 0.0}, {kDragged}}, {{0.0, -0.04}, {kTurned}}, {{0.06, 0.03}, {kDragged, kTurned}}};
    for (const auto& [sizes, causes] : cases) {
        const Pendulum pendulum(sizes[0], sizes[1], 0.002, 3);
        const Search found = search(Problem(pendulum), {.jobs = 1, .progress = {}});
        ASSERT_EQ(found.best().causes.size(), causes.size());
        EXPECT_TRUE(std::is_permutation(causes.begin(), causes.end(), found.best().causes.begin()));
        EXPECT_GT(found.probability.front(), 0.9);
    }
}

TEST(Model, AHypothesisThatTheModelRefusesIsOutAndNoError) {
    const Pendulum pendulum(0.1, 0.0, 0.0, 5);
    const Problem problem(pendulum);
    EXPECT_TRUE(problem.residual({kHollow}, problem.start({kHollow})).array().isNaN().all());
    const Search found = search(problem, {.jobs = 1, .progress = {}});
    for (const Fit& fit : found.fits) EXPECT_EQ(std::count(fit.causes.begin(), fit.causes.end(), kHollow), 0);
    for (const double probability : found.probability) EXPECT_TRUE(std::isfinite(probability));
}

TEST(Model, TheSameForAnyNumberOfThreads) {
    const Pendulum pendulum(0.06, 0.03, 0.0, 7);
    const Search one = search(Problem(pendulum), {.jobs = 1, .progress = {}}),
                 four = search(Problem(pendulum), {.jobs = 4, .progress = {}});
    ASSERT_EQ(one.fits.size(), four.fits.size());
    for (std::size_t i = 0; i < one.fits.size(); ++i) EXPECT_EQ(one.fits[i].x, four.fits[i].x);
}

TEST(Problem, AnUnknownEffectIsRefusedWithTheNearestName) {
    const Pendulum pendulum(0.0, 0.0, 0.0, 1);
    try {
        (void)Problem(pendulum).effect("pivot.drga");
        FAIL() << "taken";
    } catch (const core::InvalidInput& e) {
        EXPECT_NE(e.allowed().find("pivot.drag"), std::string::npos) << e.what();
    }
}

}  // namespace
}  // namespace fusee::inference
