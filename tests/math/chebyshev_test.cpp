#include "fusee/math/chebyshev.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fusee::math {
namespace {

ChebyshevSeries series_of(core::Range domain, double (*f)(double)) {
    const auto x = ChebyshevSeries::points(domain);
    ChebyshevSeries::Values y{};
    for (std::size_t i = 0; i < x.size(); ++i) y[i] = f(x[i]);
    return {domain, y};
}

TEST(ChebyshevSeries, ReproducesAPolynomialWithItsSlopeAndArea) {
    const core::Range domain{-1.0, 3.0};
    const auto series = series_of(domain, [](double x) { return 1.0 + x * (2.0 - x * x * (0.5 + 0.1 * x * x)); });
    EXPECT_LT(series.tail(), 1e-14);
    const auto slope = series.derivative();
    const auto area = series.integral();
    for (double x = -1.0; x <= 3.0; x += 0.1) {  // values up to 40
        EXPECT_NEAR(series(x), 1.0 + 2.0 * x - 0.5 * std::pow(x, 3) - 0.1 * std::pow(x, 5), 1e-13);
        EXPECT_NEAR(slope(x), 2.0 - 1.5 * x * x - 0.5 * std::pow(x, 4), 1e-12);
        EXPECT_NEAR(area(x), x + 1.0 + x * x - 1.0 - (std::pow(x, 4) - 1.0) / 8.0 - (std::pow(x, 6) - 1.0) / 60.0, 1e-13);
    }
    EXPECT_NEAR(area(-1.0), 0.0, 1e-15);
}

TEST(ChebyshevSeries, OfAConstantHasSlopeZero) {
    const auto series = series_of({0.0, 2.0}, [](double) { return 3.0; });
    EXPECT_NEAR(series(1.3), 3.0, 1e-15);
    EXPECT_NEAR(series.derivative()(0.7), 0.0, 1e-14);
    EXPECT_NEAR(series.integral()(2.0), 6.0, 1e-15);
}

TEST(ChebyshevSeries, TheFullDegreeCanBeIntegratedAndDerived) {
    const auto series = series_of({0.0, 1.0}, [](double x) { return std::pow(x, 16); });
    EXPECT_NEAR(series.integral()(1.0), 1.0 / 17.0, 1e-16);
    EXPECT_NEAR(series.integral().derivative()(0.9), std::pow(0.9, 16), 1e-14);
}

TEST(PiecewiseChebyshev, ResolvesASteepFunctionWithThreeDerivatives) {
    // 1/(x + 0.01): values 100 to 0.5, poles close by.
    const PiecewiseChebyshev series([](double x) { return 1.0 / (x + 0.01); }, {0.0, 2.0});
    EXPECT_FALSE(series.rough());
    for (int i = 0; i <= 200; ++i) {
        const double x = 2.0 * i / 200.0, f = 1.0 / (x + 0.01);
        EXPECT_NEAR(series.value(x), f, 1e-11 * f);  // rounding of the largest value weighs 200 times at the smallest
        EXPECT_NEAR(series.derivative(x, 1), -f * f, 1e-10 * f * f);
        EXPECT_NEAR(series.derivative(x, 3), -6.0 * f * f * f * f, 1e-6 * f * f * f * f);
        EXPECT_NEAR(series.integral(x), std::log1p(100.0 * x), 1e-13 * 5.3);
    }
}

TEST(PiecewiseChebyshev, SeesANarrowFeature) {
    const auto f = [](double x) { return 1.0 + 0.1 * std::exp(-std::pow((x - 0.87) / 0.01, 2)); };
    const PiecewiseChebyshev series(f, {0.0, 2.0});
    EXPECT_FALSE(series.rough());
    EXPECT_GT(series.pieces(), 8u);
    EXPECT_NEAR(series.value(0.875), f(0.875), 1e-12);
}

TEST(PiecewiseChebyshev, NamesTheKinkWhereverItLies) {
    for (const double kink : {0.25, 0.5, 0.7, 1.0, 1.9}) {
        for (const int power : {0, 1, 2}) {
            const PiecewiseChebyshev series([&](double x) { return x < kink ? 1.0 : 1.0 + std::pow(x - kink, power) + (power == 0); },
                                            {0.0, 2.0});
            ASSERT_TRUE(series.rough()) << kink << " " << power;
            EXPECT_NEAR(*series.rough(), kink, 2.0 / 500.0);  // ten divisions by about 2
        }
        const PiecewiseChebyshev smooth([&](double x) { return x < kink ? 1.0 : 1.0 + std::pow(x - kink, 3); }, {0.0, 2.0});
        EXPECT_FALSE(smooth.rough()) << kink;
    }
}

TEST(PiecewiseChebyshev, IsClampedToItsDomain) {
    const PiecewiseChebyshev series([](double x) { return std::sin(x); }, {0.5, 1.5});
    EXPECT_EQ(series.value(2.0), series.value(1.5));
    EXPECT_EQ(series.integral(-1.0), series.integral(0.5));
    EXPECT_EQ(series.domain().low, 0.5);
    EXPECT_EQ(series.domain().high, 1.5);
}

}  // namespace
}  // namespace fusee::math
