#include <ceres/ceres.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fusee/core/error.h"
#include "fusee/math/statistics.h"

namespace fusee::math {
namespace {

std::vector<double> ones(std::size_t rows) { return std::vector<double>(rows, 1.0); }

// NIST Statistical Reference Datasets, "Norris": ozone monitors; certified values to 15 digits.
TEST(FitLinear, NorrisOfNist) {
    const std::vector<double> y{0.1, 338.8, 118.1, 888.0, 9.2,   228.1, 668.5, 998.5, 449.1, 778.9, 559.2, 0.3,
                                0.1, 778.1, 668.8, 339.3, 448.9, 10.8,  557.7, 228.3, 998.0, 888.8, 119.6, 0.3,
                                0.6, 557.6, 339.3, 888.0, 998.5, 778.9, 10.2,  117.6, 228.9, 668.4, 449.2, 0.2};
    const std::vector<double> x{0.2, 337.4, 118.2, 884.6, 10.1,  226.5, 666.3, 996.3, 448.6, 777.0, 558.2, 0.4,
                                0.6, 775.5, 666.9, 338.0, 447.5, 11.6,  556.0, 228.1, 995.8, 887.6, 120.2, 0.3,
                                0.3, 556.8, 339.1, 887.2, 999.0, 779.0, 11.1,  118.3, 229.2, 669.1, 448.9, 0.5};
    const LinearFit fit = fit_linear({{ones(36), x}, y, {}, {}});
    // 1e-12 relative: 36 rows of numbers of size 1000 lose three of sixteen digits.
    EXPECT_NEAR(fit.coefficients[0], -0.262323073774029, 1e-12);
    EXPECT_NEAR(fit.coefficients[1], 1.00211681802045, 2e-14);
    EXPECT_NEAR(std::sqrt(fit.covariance[0][0]), 0.232818234301152, 1e-12);
    EXPECT_NEAR(std::sqrt(fit.covariance[1][1]), 0.429796848199937e-03, 1e-15);
    EXPECT_NEAR(fit.deviation, 0.884796396144373, 1e-12);
    EXPECT_EQ(fit.freedom, 34u);
}

// NIST "NoInt1": y = b x without a constant.
TEST(FitLinear, NoInt1OfNistAndItsInterval) {
    std::vector<double> x, y;
    for (int i = 0; i <= 10; ++i) {
        x.push_back(60 + i);
        y.push_back(130 + i);
    }
    const LinearFit fit = fit_linear({{x}, y, {}, {}});
    EXPECT_NEAR(fit.coefficients[0], 2.07438016528926, 1e-14);
    EXPECT_NEAR(fit.deviation, 3.56753034006338, 1e-13);
    // t of 10 degrees of freedom is 2.22813885196 (tables), times the certified standard deviation
    EXPECT_NEAR(fit.interval(0).width() / 2, 2.22813885196 * 0.165289256198347e-01, 1e-12);
    EXPECT_NEAR(fit.interval_at({10.0}).width(), 10.0 * fit.interval(0).width(), 1e-13);
}

TEST(FitLinear, AWeightOfTwoIsTheRowTwice) {
    const std::vector<double> x{1, 2, 3, 4}, y{1.1, 1.9, 3.2, 3.9};
    const LinearFit weighted = fit_linear({{ones(4), x}, y, {}, {1, 1, 2, 1}});
    const LinearFit repeated = fit_linear({{ones(5), {1, 2, 3, 3, 4}}, {1.1, 1.9, 3.2, 3.2, 3.9}, {}, {}});
    for (int j = 0; j < 2; ++j) EXPECT_NEAR(weighted.coefficients[j], repeated.coefficients[j], 1e-14);
    EXPECT_NEAR(weighted.residuals[2], repeated.residuals[2], 1e-14);
}

// x measured with noise: least squares bends towards 0 by var(noise)/var(x), instruments do not.
TEST(FitLinear, InstrumentsRemoveTheBiasOfANoisyRegressor) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> noise(0.0, 1.0);
    const std::size_t rows = 20'000;
    std::vector<double> z(rows), x(rows), y(rows);
    for (std::size_t i = 0; i < rows; ++i) {
        z[i] = 2.0 * noise(random);
        x[i] = z[i] + noise(random);
        y[i] = 1.0 + 0.5 * z[i];
    }
    EXPECT_NEAR(fit_linear({{ones(rows), x}, y, {}, {}}).coefficients[1], 0.5 * 4.0 / 5.0, 0.01);  // 0.01: five standard errors
    const LinearFit fit = fit_linear({{ones(rows), x}, y, {ones(rows), z}, {}});
    EXPECT_NEAR(fit.coefficients[1], 0.5, 0.01);
    EXPECT_TRUE(fit.interval(1, 0.9999).holds(0.5));
}

TEST(FitLinear, UnitsDoNotMatterAndDependenceIsRefused) {
    const std::vector<double> x{1e-6, 2e-6, 3e-6, 5e-6}, squares{1e-12, 4e-12, 9e-12, 25e-12}, y{1, 4, 9, 25};
    EXPECT_NEAR(fit_linear({{ones(4), x, squares}, y, {}, {}}).coefficients[2], 1e12, 1e3);
    EXPECT_THROW((void)fit_linear({{ones(4), ones(4)}, y, {}, {}}), core::InvalidInput);
    EXPECT_THROW((void)fit_linear({{ones(4), std::vector<double>(4, 0.0)}, y, {}, {}}), core::InvalidInput);
    EXPECT_THROW((void)fit_linear({{ones(2), {1, 2}}, {1, 2}, {}, {}}), core::InvalidInput);
}

struct Line {
    double x, y, deviation;
    template <class T>
    bool operator()(const T* b, T* residual) const {
        residual[0] = (T(y) - b[0] - b[1] * T(x)) / T(deviation);
        return true;
    }
};

// Two algorithms: reweighting, and Ceres's Levenberg-Marquardt on Huber's loss at the same deviation.
TEST(FitRobust, AgreesWithCeresAndIgnoresOutliers) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> noise(0.0, 0.01);
    std::vector<double> x, y;
    for (int i = 0; i < 60; ++i) {
        x.push_back(0.1 * i);
        y.push_back(0.3 + 0.25 * x.back() + noise(random) + (i % 12 == 5 ? 1.0 : 0.0));
    }
    const RobustFit fit = fit_robust({{ones(60), x}, y, {}, {}});
    double b[2] = {0.0, 0.0};
    ceres::Problem problem;
    for (std::size_t i = 0; i < x.size(); ++i)
        problem.AddResidualBlock(new ceres::AutoDiffCostFunction<Line, 1, 2>(new Line{x[i], y[i], fit.deviation}),
                                 new ceres::HuberLoss(1.345), b);
    ceres::Solver::Options options;
    options.function_tolerance = options.parameter_tolerance = options.gradient_tolerance = 1e-15;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    EXPECT_NEAR(fit.coefficients[0], b[0], 1e-7);  // what Ceres's stopping rule leaves
    EXPECT_NEAR(fit.coefficients[1], b[1], 1e-7);
    EXPECT_NEAR(fit.coefficients[1], 0.25, 0.003);  // four standard errors; least squares is off by more:
    EXPECT_GT(std::abs(fit_linear({{ones(60), x}, y, {}, {}}).coefficients[0] - 0.3), 0.05);
    EXPECT_NEAR(fit.deviation, 0.01, 0.004);
    for (std::size_t i = 0; i < 60; ++i) EXPECT_EQ(fit.scores[i] > 20.0, i % 12 == 5) << i;
}

TEST(FitRobust, RowsWithoutNoise) {
    std::vector<double> x, y;
    for (int i = 0; i < 10; ++i) {
        x.push_back(i);
        y.push_back(2.0 * i + (i == 4 ? 3.0 : 0.0));
    }
    const RobustFit fit = fit_robust({{x}, y, {}, {}});
    EXPECT_NEAR(fit.coefficients[0], 2.0, 1e-9);
    EXPECT_GT(fit.scores[4], 1e6);
}

TEST(Distributions, OfTheTables) {
    EXPECT_NEAR(student_quantile(0.95, 1), 12.7062047364, 1e-9);
    EXPECT_NEAR(student_quantile(0.99, 30), 2.74999565357, 1e-9);
    EXPECT_NEAR(f_tail(4.10282101526, 2, 10), 0.05, 1e-9);
}

}  // namespace
}  // namespace fusee::math
