#include "fusee/spring/potential.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "refused.h"

namespace fusee::spring {
namespace {

/// U' = F, F' = S, S' = slope by central differences; h^2/6 of derivatives of order `size` bounds the error.
void expect_consistent(const Potential& potential, double low, double high, double size) {
    const double h = 1e-5 * (high - low);
    for (int i = 1; i < 30; ++i) {
        const double x = low + (high - low) * i / 30.0;
        EXPECT_NEAR((potential.energy(x + h) - potential.energy(x - h)) / (2.0 * h), potential.force(x), 1e-8 * size);
        EXPECT_NEAR((potential.force(x + h) - potential.force(x - h)) / (2.0 * h), potential.stiffness(x), 1e-8 * size);
        EXPECT_NEAR((potential.stiffness(x + h) - potential.stiffness(x - h)) / (2.0 * h), potential.slope(x), 1e-8 * size);
    }
}

TEST(Polynomial, IsItsFormula) {
    const PotentialPtr cubic = make_polynomial({0.1, 0.0, 0.02, 0.005});
    EXPECT_NEAR(cubic->force(2.0), 0.1 + 0.08 + 0.04, 1e-15);
    EXPECT_NEAR(cubic->energy(2.0), 0.2 + 0.16 / 3.0 + 0.02, 1e-15);
    EXPECT_NEAR(cubic->stiffness(2.0), 0.08 + 0.06, 1e-15);
    EXPECT_NEAR(cubic->slope(2.0), 0.04 + 0.06, 1e-15);
    EXPECT_EQ(cubic->energy(0.0), 0.0);
    expect_consistent(*cubic, 0.0, 5.0, 5.0);
}

TEST(Exponential, IsItsFormula) {
    const PotentialPtr spring = make_exponential(0.2, 0.7, 0.05);
    EXPECT_EQ(spring->force(0.0), 0.05);
    EXPECT_EQ(spring->energy(0.0), 0.0);
    EXPECT_NEAR(spring->force(2.0), 0.2 * (std::exp(1.4) - 1.0) + 0.05, 1e-15);
    EXPECT_NEAR(spring->slope(2.0), 0.2 * 0.49 * std::exp(1.4), 1e-15);
    expect_consistent(*spring, 0.0, 4.0, 5.0);
}

struct Measured {
    std::vector<double> x, force;
};
double true_force(double x) { return 0.1 + 0.08 * x + 0.2 * (std::exp(0.6 * x) - 1.0); }
double true_stiffness(double x) { return 0.08 + 0.12 * std::exp(0.6 * x); }
constexpr double kReach = 3.0;

/// Rows of a progressive spring with Gaussian noise of `share` of its peak torque.
Measured measured(int rows, double share, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, 1.0);
    Measured table;
    for (int i = 0; i < rows; ++i) {
        const double x = kReach * i / (rows - 1);
        table.x.push_back(x);
        table.force.push_back(true_force(x) + share * true_force(kReach) * noise(random));
    }
    return table;
}

TEST(Tabulated, IsConsistent) {
    const Measured table = measured(80, 0.01, 3);
    const PotentialPtr spring = make_tabulated(table.x, table.force);
    EXPECT_EQ(spring->domain().low, 0.0);
    EXPECT_EQ(spring->domain().high, kReach);
    EXPECT_NEAR(spring->energy(0.0), 0.0, 1e-15);
    expect_consistent(*spring, 0.0, kReach, 5.0);
}

TEST(Tabulated, RecoversForceAndStiffnessFromOnePercentNoise) {
    const double peak = true_force(kReach), stiffest = true_stiffness(kReach);
    for (unsigned seed = 1; seed <= 25; ++seed) {
        const Measured table = measured(100, 0.01, seed);
        const PotentialPtr spring = make_tabulated(table.x, table.force);
        for (int i = 0; i <= 200; ++i) {
            const double x = kReach * i / 200.0;
            // About 5 parameters from 100 rows: sigma sqrt(5/100) inside, about twice that at the ends; 4 deviations.
            EXPECT_NEAR(spring->force(x), true_force(x), 0.02 * peak) << seed << " at " << x;
            EXPECT_GT(spring->stiffness(x), 0.0) << seed << " at " << x;
            // The slope of such a fit over the reach L errs by about sigma sqrt(12/100)/L * 3 inside and several times that at its free
            // ends.
            const bool inside = x > 0.1 * kReach && x < 0.9 * kReach;
            EXPECT_NEAR(spring->stiffness(x), true_stiffness(x), (inside ? 0.06 : 0.25) * stiffest) << seed << " at " << x;
        }
    }
}

/// A search over the cams of one law asks for it thousands of times.
TEST(Tabulated, TheSameRowsAreFittedOnce) {
    const Measured table = measured(80, 0.01, 3), other = measured(80, 0.01, 4);
    const PotentialPtr spring = make_tabulated(table.x, table.force);
    EXPECT_EQ(make_tabulated(table.x, table.force), spring);
    EXPECT_NE(make_tabulated(table.x, other.force), spring);
    EXPECT_NE(make_tabulated(table.x, table.force, {.knots = 8}), spring);
}

TEST(Tabulated, WithoutSmoothingACubicIsReproduced) {
    const PotentialPtr truth = make_polynomial({0.1, 0.2, 0.0, 0.03});
    Measured table;
    for (int i = 0; i < 60; ++i) {
        table.x.push_back(0.05 * i);
        table.force.push_back(truth->force(0.05 * i));
    }
    const PotentialPtr spring = make_tabulated(table.x, table.force, {.knots = 8, .smoothing = 0.0});
    for (double x = 0.0; x < 2.95; x += 0.0173) {
        EXPECT_NEAR(spring->force(x), truth->force(x), 1e-12);
        EXPECT_NEAR(spring->energy(x), truth->energy(x), 1e-12);
        EXPECT_NEAR(spring->stiffness(x), truth->stiffness(x), 1e-11);
        EXPECT_NEAR(spring->slope(x), truth->slope(x), 1e-9);  // two differences over knots at a distance of 0.37
    }
}

TEST(PotentialRefusal, BadInputIsNamed) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(field_refused([] { return make_polynomial({}); }), "coefficients");
    EXPECT_EQ(field_refused([&] { return make_polynomial({0.1, nan}); }), "coefficients[1]");
    EXPECT_EQ(field_refused([] { return make_exponential(0.0, 1.0, 0.0); }), "scale");
    EXPECT_EQ(field_refused([&] { return make_exponential(1.0, nan, 0.0); }), "rate");
    EXPECT_EQ(field_refused([&] { return make_exponential(1.0, 1.0, nan); }), "offset");
    Measured good = measured(20, 0.0, 1);
    EXPECT_EQ(field_refused([&] { return make_tabulated({0, 1, 2}, {0, 1, 2}); }), "x");
    EXPECT_EQ(field_refused([&] { return make_tabulated(good.x, {0, 1, 2}); }), "force");
    EXPECT_EQ(field_refused([&] { return make_tabulated(good.x, good.force, {.knots = 0, .smoothing = -1.0}); }), "knots");
    EXPECT_EQ(field_refused([&] { return make_tabulated(good.x, good.force, {.knots = 8, .smoothing = nan}); }), "smoothing");
    Measured gap = good;
    gap.force[7] = nan;
    EXPECT_EQ(field_refused([&] { return make_tabulated(gap.x, gap.force); }), "force[7]");
    gap = good;
    gap.x[5] = gap.x[4];
    EXPECT_EQ(field_refused([&] { return make_tabulated(gap.x, gap.force); }), "x[5]");
}

}  // namespace
}  // namespace fusee::spring
