#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fusee/core/error.h"
#include "fusee/paper/paper.h"
#include "fusee/spring/laws.h"
#include "fusee/spring/potential.h"
#include "refused.h"

namespace fusee::paper {
namespace {

class Muscles {
public:
    LinearMuscle next() { return {.k_se = between(0.05, 20.0), .k_pe = between(0.0, 20.0)}; }
    double between(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }

private:
    std::mt19937_64 random_{20140712};
};

TEST(Hill, ByHand) {
    // K_SE = 3, K_PE = 1, stretched by 2 under 0.4: 3 (2 - l) = l + 0.4, l = 1.4, F = 1.8.
    const LinearMuscle muscle{.k_se = 3.0, .k_pe = 1.0};
    EXPECT_NEAR(series_contractile(muscle, 2.0, 0.4), 1.4, 1e-15);
    EXPECT_NEAR(series_force(muscle, 2.0, 0.4), 1.8, 1e-15);
    const LinearMuscle parallel = parallel_from_series(muscle);
    EXPECT_NEAR(parallel.k_se, 2.25, 1e-15);
    EXPECT_NEAR(parallel.k_pe, 0.75, 1e-15);
    EXPECT_NEAR(parallel_force({.k_se = 2.0, .k_pe = 0.5}, 2.0, 1.5), 2.0, 1e-15);  // 0.5 * 2 + 2 * 0.5
}

TEST(Hill, BothArrangementsAreOneMuscle) {
    Muscles muscles;
    for (int i = 0; i < 1000; ++i) {
        const LinearMuscle series = muscles.next(), parallel = parallel_from_series(series);
        const double length = muscles.between(-1.0, 1.0), active = muscles.between(-2.0, 2.0);
        const double force = series_force(series, length, active);
        const double x = contractile_from_active(series, length, active);
        // A few roundings of terms up to 20.
        ASSERT_NEAR(parallel_force(parallel, length, x), force, 1e-13);
        ASSERT_NEAR(force, series.k_pe * series_contractile(series, length, active) + active, 1e-13);
    }
}

// The contractile element does the same work in both: they cannot be distinguished from outside.
TEST(Hill, ContractileElementsDoTheSameWork) {
    Muscles muscles;
    for (int i = 0; i < 100; ++i) {
        const LinearMuscle series = muscles.next(), parallel = parallel_from_series(series);
        double work_series = 0.0, work_parallel = 0.0, l = 0.0, x = 0.0, f = 0.0, g = 0.0;
        for (int step = 0; step < 20; ++step) {
            const double length = muscles.between(-1.0, 1.0), active = muscles.between(0.0, 2.0);
            const double l_next = series_contractile(series, length, active), x_next = contractile_from_active(series, length, active);
            const double g_next = parallel.k_se * (length - x_next);
            // Along straight strokes all is linear, so the trapezium is exact.
            work_series += 0.5 * (f + active) * (l_next - l);
            work_parallel += 0.5 * (g + g_next) * (x_next - x);
            l = l_next, x = x_next, f = active, g = g_next;
        }
        EXPECT_NEAR(work_series, work_parallel, 1e-12 * (1.0 + std::abs(work_series)));
    }
}

TEST(PassiveTension, LinearSpringsAreKnown) {
    const auto tension = passive_tension(spring::make_polynomial({0.0, 3.0}), spring::make_polynomial({0.0, 1.0}));
    const LinearMuscle parallel = parallel_from_series({.k_se = 3.0, .k_pe = 1.0});
    EXPECT_NEAR(tension->domain().low, 0.0, 1e-15);
    EXPECT_NEAR(tension->domain().high, 100.0 + 100.0 / 3.0, 1e-12);  // K_PE ends first, at 100 Nm
    for (const double length : {0.1, 1.0, 40.0}) {
        EXPECT_NEAR(tension->force(length), parallel.k_pe * length, 1e-13 * length);
        EXPECT_NEAR(tension->stiffness(length), parallel.k_pe, 1e-15);
        EXPECT_NEAR(tension->energy(length), 0.5 * parallel.k_pe * length * length, 1e-13 * length * length);
        EXPECT_NEAR(tension->slope(length), 0.0, 1e-15);
    }
}

TEST(PassiveTension, QuadraticSpringsAreKnown) {
    // F = a x^2 and b x^2 share the stretch in a constant ratio: F = L^2 / (1/sqrt(a) + 1/sqrt(b))^2.
    const double a = 0.04, b = 0.25, c = std::pow(1.0 / std::sqrt(a) + 1.0 / std::sqrt(b), -2);
    const auto tension = passive_tension(spring::make_polynomial({0.0, 0.0, a}), spring::make_polynomial({0.0, 0.0, b}));
    for (const double length : {0.5, 2.0, 7.0}) {
        EXPECT_NEAR(tension->force(length), c * length * length, 1e-13 * length * length);
        EXPECT_NEAR(tension->stiffness(length), 2.0 * c * length, 1e-13 * length);
        EXPECT_NEAR(tension->slope(length), 2.0 * c, 1e-13);
        EXPECT_NEAR(tension->energy(length), c * length * length * length / 3.0, 1e-13 * length * length * length);
    }
}

struct SpringPair {
    const char* name;
    spring::PotentialPtr k_se, k_pe;
};

std::vector<SpringPair> pairs() {
    const auto law = *spring::make_stiction_law({.k = 0.225, .u = 0.0012, .c = 0.265, .mu = 0.28, .start_torque = 0.6, .end_torque = 2.4});
    return {{"polynomial", spring::make_polynomial({0.0, 0.10, 0.02}), spring::make_polynomial({0.0, 0.25, 0.03})},
            {"exponential", spring::make_exponential(0.1, 9.0, 0.02), spring::make_exponential(0.2, 1.5, 0.0)},
            {"preloaded", spring::make_polynomial({0.3, 0.10, 0.02}), spring::make_polynomial({0.0, 0.25, 0.0, 0.03})},
            {"stiction law", spring::series_spring(law), spring::parallel_spring(law)}};
}

TEST(PassiveTension, IsAConvexPotential) {
    for (const SpringPair& pair : pairs()) {
        if (pair.name == std::string("stiction law")) continue;  // see below: its springs have few torques in common
        const auto tension = passive_tension(pair.k_se, pair.k_pe);
        const double low = tension->domain().low, high = std::min(tension->domain().high, low + 3.0), h = 1e-5;
        for (int i = 1; i < 30; ++i) {
            const double length = low + (high - low) * i / 30.0, force = tension->force(length), stiffness = tension->stiffness(length);
            EXPECT_GT(stiffness, 0.0) << pair.name;
            EXPECT_LT(stiffness, std::min(pair.k_pe->stiffness(high), pair.k_se->stiffness(high)) + 1e-12) << pair.name;
            // Central differences: h^2 of the third derivative, and rounding over h.
            const double scale = 1.0 + force + stiffness + std::abs(tension->slope(length));
            EXPECT_NEAR((tension->energy(length + h) - tension->energy(length - h)) / (2.0 * h), force, 1e-7 * scale) << pair.name;
            EXPECT_NEAR((tension->force(length + h) - tension->force(length - h)) / (2.0 * h), stiffness, 1e-7 * scale) << pair.name;
            EXPECT_NEAR((tension->stiffness(length + h) - tension->stiffness(length - h)) / (2.0 * h), tension->slope(length), 1e-7 * scale)
                << pair.name;
        }
    }
}

// The split is the one of least energy: any other way to share the stretch costs more.
TEST(PassiveTension, SharesTheStretchAtLeastEnergy) {
    for (const SpringPair& pair : pairs()) {
        const auto tension = passive_tension(pair.k_se, pair.k_pe);
        const core::Range se = pair.k_se->domain(), pe = pair.k_pe->domain();
        const double high = std::min(tension->domain().high, tension->domain().low + 2.0);
        for (int i = 0; i <= 10; ++i) {
            const double length = tension->domain().low + (high - tension->domain().low) * i / 10.0;
            const double least = tension->energy(length);
            for (int j = 0; j <= 400; ++j) {
                const double l = pe.low + (length - pe.low - se.low) * j / 400.0;
                if (!se.holds(length - l) || !pe.holds(l)) continue;
                EXPECT_GE(pair.k_se->energy(length - l) + pair.k_pe->energy(l), least - 1e-13 * (1.0 + least)) << pair.name;
            }
        }
    }
}

// Below the greater preload one spring rests on its stop: the domain begins where both deflect.
TEST(PassiveTension, BeginsWhereBothSpringsGive) {
    const auto tension = passive_tension(spring::make_polynomial({0.3, 0.1}), spring::make_polynomial({0.0, 0.2}));
    EXPECT_NEAR(tension->domain().low, 1.5, 1e-14);
    EXPECT_NEAR(tension->force(1.5), 0.3, 1e-14);
}

TEST(HillRefusal, BadMusclesAreNamed) {
    EXPECT_THROW((void)series_force({.k_se = 0.0, .k_pe = 1.0}, 1.0, 0.0), core::InvalidInput);
    EXPECT_THROW((void)parallel_from_series({.k_se = 1.0, .k_pe = -1.0}), core::InvalidInput);
    EXPECT_THROW((void)passive_tension(nullptr, spring::make_polynomial({0.0, 1.0})), core::InvalidInput);
    const auto softening = spring::make_polynomial({0.0, 1.0, -0.1});
    EXPECT_EQ(field_refused([&] { return passive_tension(spring::make_polynomial({0.0, 1.0}), softening); }), "k_pe");
    // Forces 0 to 100 Nm and 200 Nm on: nothing in common.
    EXPECT_THROW((void)passive_tension(spring::make_polynomial({0.0, 1.0}), spring::make_polynomial({200.0, 1.0})), core::InvalidInput);
}

}  // namespace
}  // namespace fusee::paper
