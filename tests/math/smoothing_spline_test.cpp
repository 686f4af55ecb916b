#include "fusee/math/smoothing_spline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "penalised_fit.h"

namespace fusee::math {
namespace {

std::vector<double> even(double low, double high, int count) {
    std::vector<double> x;
    for (int i = 0; i < count; ++i) x.push_back(low + (high - low) * i / (count - 1));
    return x;
}

template <class F>
std::vector<double> apply(const std::vector<double>& x, F f) {
    std::vector<double> y;
    for (const double at : x) y.push_back(f(at));
    return y;
}

TEST(SmoothingSpline, WithoutAPenaltyAQuinticIsReproduced) {
    const auto f = [](double x) { return 1.0 + x * (-2.0 + x * (0.5 + x * (0.3 + x * (-0.2 + 0.04 * x)))); };
    const auto slope = [](double x) { return -2.0 + x * (1.0 + x * (0.9 + x * (-0.8 + 0.2 * x))); };
    const auto bend = [](double x) { return 1.0 + x * (1.8 + x * (-2.4 + 0.8 * x)); };
    const auto third = [](double x) { return 1.8 + x * (-4.8 + 2.4 * x); };
    const auto area = [](double x) { return x * (1.0 + x * (-1.0 + x * (0.5 / 3 + x * (0.075 + x * (-0.04 + 0.04 / 6 * x))))); };
    const auto x = even(-1.0, 3.0, 60);
    const SmoothingSpline spline(x, apply(x, f), {.intervals = 10, .lambda = 0.0});
    for (const double at : even(-1.0, 3.0, 77)) {
        EXPECT_NEAR(spline.value(at), f(at), 1e-12);  // values of order 1; each derivative loses a factor of the knots' number
        EXPECT_NEAR(spline.derivative(at, 1), slope(at), 1e-11);
        EXPECT_NEAR(spline.derivative(at, 2), bend(at), 1e-10);
        EXPECT_NEAR(spline.derivative(at, 3), third(at), 1e-8);
        EXPECT_NEAR(spline.integral(at), area(at) - area(-1.0), 1e-12);
    }
    EXPECT_EQ(spline.lambda(), 0.0);
    EXPECT_NEAR(spline.effective_parameters(), 15.0, 1e-9);
}

TEST(SmoothingSpline, WithAHugePenaltyTheBestParabolaIsLeft) {
    const auto x = even(0.0, 2.0, 41);
    const auto y = apply(x, [](double at) { return at * at * at; });
    const SmoothingSpline spline(x, y, {.intervals = 12, .lambda = 1e12});
    EXPECT_NEAR(spline.effective_parameters(), 3.0, 1e-6);
    // The cubic's best parabola is odd about x = 1: residual of (x - 1)^3 alone, with its own best line taken out.
    EXPECT_NEAR(spline.value(1.0), 1.0, 1e-6);
    EXPECT_NEAR(spline.derivative(0.3, 2), spline.derivative(1.7, 2), 1e-5);
}

TEST(SmoothingSpline, CrossValidationFindsTheNoise) {
    const auto f = [](double x) { return std::sin(3.0 * x); };
    const double sigma = 0.02;
    for (unsigned seed = 1; seed <= 20; ++seed) {
        std::mt19937 random(seed);
        std::normal_distribution<double> noise(0.0, sigma);
        const auto x = even(0.0, 2.0, 120);
        const SmoothingSpline spline(x, apply(x, [&](double at) { return f(at) + noise(random); }));
        // The deviation of 120 rows scatters by 1/sqrt(2 * 110) = 7 %; 4 deviations.
        EXPECT_NEAR(spline.noise(), sigma, 0.28 * sigma) << seed;
        EXPECT_GT(spline.effective_parameters(), 4.0) << seed;
        EXPECT_LT(spline.effective_parameters(), 14.0) << seed;
        double square = 0.0;
        for (const double at : x) square += std::pow(spline.value(at) - f(at), 2) / 120.0;
        // A fit with p parameters errs by sigma sqrt(p/n) = 0.29 sigma at p = 10; twice that.
        EXPECT_LT(std::sqrt(square), 0.6 * sigma) << seed;
    }
}

TEST(SmoothingSpline, CrossValidationKeepsCleanDataClean) {
    const auto x = even(0.0, 2.0, 120);
    const SmoothingSpline spline(x, apply(x, [](double at) { return std::exp(at); }));
    for (const double at : even(0.0, 2.0, 50)) EXPECT_NEAR(spline.value(at), std::exp(at), 1e-6);
}

TEST(SmoothingSpline, FewRowsAndUnevenRowsAreFine) {
    const std::vector<double> x{0.0, 0.1, 0.15, 0.4, 0.45, 0.8, 0.9, 1.0};
    for (const double lambda : {-1.0, 0.0}) {
        const SmoothingSpline spline(x, apply(x, [](double at) { return 1.0 + at * at; }), {.intervals = 16, .lambda = lambda});
        for (const double at : x) EXPECT_NEAR(spline.value(at), 1.0 + at * at, 1e-9);
    }
}

TEST(SmoothingSpline, IsClampedToItsDomain) {
    const auto x = even(0.0, 1.0, 20);
    const SmoothingSpline spline(x, apply(x, [](double at) { return at; }));
    EXPECT_EQ(spline.value(2.0), spline.value(1.0));
    EXPECT_EQ(spline.integral(-1.0), spline.integral(0.0));
    EXPECT_NEAR(spline.integral(0.0), 0.0, 1e-15);
}

/// The banded and the dense fit of the same rows.
TEST(SmoothingSpline, BandedAndDenseFitsAgree) {
    constexpr std::size_t kCount = 45;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> value(0.1, 1.0);
    std::vector<PenalisedFit::Row> rows;
    for (std::size_t i = 0; i < 300; ++i) {
        PenalisedFit::Row& row = rows.emplace_back(PenalisedFit::Row{i * (kCount - 5) / 300, {}, value(random)});
        for (double& entry : row.values) entry = value(random);
    }
    const auto dense = make_dense_fit(rows, kCount), banded = make_banded_fit(rows, kCount);
    for (const double lambda : {1e-6, 1.0, 1e6}) {
        const auto a = dense->solve(lambda), b = banded->solve(lambda);
        for (std::size_t i = 0; i < kCount; ++i) EXPECT_NEAR(a.coefficients[i], b.coefficients[i], 1e-9) << lambda;
        EXPECT_NEAR(a.residual, b.residual, 1e-9 * a.residual) << lambda;
        EXPECT_NEAR(a.parameters, b.parameters, 1e-8) << lambda;
    }
    EXPECT_NEAR(std::log10(dense->choose_lambda()), std::log10(banded->choose_lambda()), 0.01);
}

/// A dense matrix of these rows would have 120 million entries, and a factorisation for each of some 50 weights.
TEST(SmoothingSpline, ManyRowsOnManyKnots) {
    std::mt19937 random(1);
    std::normal_distribution<double> noise(0.0, 0.01);
    const auto x = even(0.0, 10.0, 300'000);
    const SmoothingSpline spline(x, apply(x, [&](double at) { return std::sin(3.0 * at) + noise(random); }), {.intervals = 400});
    EXPECT_NEAR(spline.noise(), 0.01, 1e-4);
    // Inside some 1000 rows speak for each place: 0.01/sqrt(1000) = 0.0003; 6 deviations.
    for (const double at : even(0.1, 9.9, 99)) EXPECT_NEAR(spline.value(at), std::sin(3.0 * at), 0.002);
    EXPECT_LT(spline.effective_parameters(), 200.0);
}

TEST(SmoothingSpline, ManyRowsThatLeaveKnotsBareAreBridged) {
    const std::vector<double> places = even(0.0, 1.0, 200'000);
    const std::vector<double> x = apply(places, [](double at) { return at < 0.5 ? 0.1 * at : 1.0 + 0.1 * at; });
    const SmoothingSpline spline(x, apply(x, [](double at) { return 1.0 + at * at; }), {.intervals = 60, .lambda = 0.0});
    for (const double at : even(0.0, 1.1, 50)) EXPECT_NEAR(spline.value(at), 1.0 + at * at, 1e-4) << at;
}

}  // namespace
}  // namespace fusee::math
