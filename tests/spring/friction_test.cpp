#include "fusee/spring/friction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "refused.h"

namespace fusee::spring {
namespace {

/// A worn gear's table: friction rises, levels off and rises again.
FrictionLaw worn(double rest_excess = 0.0) {
    return FrictionLaw::tabulated({0.0, 0.2, 0.5, 0.9, 1.5, 2.0}, {0.02, 0.06, 0.15, 0.18, 0.18, 0.40}, rest_excess);
}

struct Named {
    const char* name;
    FrictionLaw law;
};
const Named kLaws[] = {
    {"none", FrictionLaw::proportional(0.0)},
    {"proportional", FrictionLaw::proportional(0.28)},
    {"steepest", FrictionLaw::proportional(0.95)},
    {"constant", FrictionLaw::affine(0.05, 0.0)},
    {"affine", FrictionLaw::affine(0.03, 0.2)},
    {"stribeck", FrictionLaw::affine(0.03, 0.2, 0.5)},
    {"tabulated", worn()},
    {"worn at rest", worn(0.3)},
    {"begins late", FrictionLaw::tabulated({0.5, 1.0, 2.0}, {0.1, 0.3, 0.5})},
    {"ends falling", FrictionLaw::tabulated({0.0, 1.0, 1.5}, {0.1, 0.3, 0.2})},
};

TEST(FrictionLaw, KnownAnswers) {
    EXPECT_NEAR(FrictionLaw::proportional(0.28).at_rest(1.5), 0.42, 1e-16);
    EXPECT_NEAR(FrictionLaw::proportional(0.28).at_rest(-1.5), 0.42, 1e-16);  // signed loads count with their magnitude
    EXPECT_EQ(FrictionLaw::proportional(0.28).mu(), 0.28);
    EXPECT_TRUE(FrictionLaw::proportional(0.28).is_proportional());
    const FrictionLaw affine = FrictionLaw::affine(0.05, 0.2, 0.5);
    EXPECT_FALSE(affine.is_proportional());
    EXPECT_NEAR(affine.in_motion(2.0), 0.45, 1e-15);
    EXPECT_NEAR(affine.at_rest(2.0), 0.675, 1e-15);
    EXPECT_NEAR(affine.slope(2.0), 0.3, 1e-15);
    EXPECT_NEAR(worn().at_rest(0.5), 0.15, 1e-15);  // a table keeps its rows
    EXPECT_NEAR(worn().at_rest(1.2), 0.18, 1e-15);  // and its level stretches
    EXPECT_NEAR(worn().at_rest(2.5), 0.40 + 0.5 * 0.44, 1e-15);
}

TEST(FrictionLaw, RestingLoadsAreKnownByHand) {
    const core::Range paper = FrictionLaw::proportional(0.28).resting_loads(1.5);
    EXPECT_NEAR(paper.low, 1.171875, 1e-15);
    EXPECT_NEAR(paper.high, 1.5 / 0.72, 1e-15);
    const core::Range stribeck = FrictionLaw::affine(0.05, 0.2, 0.5).resting_loads(1.0);  // 0.075 + 0.3 load at rest
    EXPECT_NEAR(stribeck.low, 0.925 / 1.3, 1e-15);
    EXPECT_NEAR(stribeck.high, 1.075 / 0.7, 1e-15);
    const core::Range moving = FrictionLaw::affine(0.05, 0.2, 0.5).moving_loads(1.0);
    EXPECT_NEAR(moving.low, 0.95 / 1.2, 1e-15);
    EXPECT_NEAR(moving.high, 1.05 / 0.8, 1e-15);
    // A motor weaker than the constant part holds the capstan against a load of either sign.
    const core::Range idle = FrictionLaw::affine(0.05, 0.2).resting_loads(0.01);
    EXPECT_NEAR(idle.low, -0.04 / 0.8, 1e-16);
    EXPECT_NEAR(idle.high, 0.06 / 0.8, 1e-16);
}

/// The ends of the range are where |motor torque - load| is the friction, whichever way the motor turns; inside, friction is to spare.
TEST(FrictionLaw, ARestingCapstanIsHeldWithinItsLoadsAndNowhereElse) {
    for (const auto& [name, law] : kLaws) {
        SCOPED_TRACE(name);
        for (const double motor : {-3.0, -0.7, -0.01, 0.0, 0.003, 0.04, 0.3, 1.0, 2.7}) {
            const core::Range rest = law.resting_loads(motor), moving = law.moving_loads(motor);
            EXPECT_NEAR(motor - rest.low, law.at_rest(rest.low), 1e-14);
            EXPECT_NEAR(rest.high - motor, law.at_rest(rest.high), 1e-14 * (1.0 + std::abs(rest.high)));
            EXPECT_NEAR(motor - moving.low, law.in_motion(moving.low), 1e-14);
            EXPECT_NEAR(moving.high - motor, law.in_motion(moving.high), 1e-14 * (1.0 + std::abs(rest.high)));
            EXPECT_LE(rest.low, moving.low + 1e-15);
            EXPECT_GE(rest.high, moving.high - 1e-15);
            const core::Range mirrored = law.resting_loads(-motor);
            EXPECT_NEAR(mirrored.low, -rest.high, 1e-14 * (1.0 + std::abs(rest.high)));
            for (int i = 1; i < 20; ++i) {
                const double load = rest.low + rest.width() * i / 20.0;
                EXPECT_LE(std::abs(motor - load), law.at_rest(load) + 1e-14 * (1.0 + std::abs(rest.high)));
            }
        }
    }
}

/// Friction opposes: a load moved round a closed path at the limits in motion takes energy from the motor and never returns any.
TEST(FrictionLaw, NeverGivesEnergy) {
    for (const auto& [name, law] : kLaws) {
        SCOPED_TRACE(name);
        for (double load = -2.5; load <= 2.5; load += 0.05) {
            EXPECT_GE(law.in_motion(load), 0.0);
            EXPECT_GE(law.at_rest(load), law.in_motion(load));
        }
        double low = -1e9, high = -1e9;
        for (double motor = -2.5; motor <= 2.5; motor += 0.05) {
            const core::Range moving = law.moving_loads(motor);
            EXPECT_LE(moving.low, motor + 1e-15);  // winding in, the load gets less than the motor's torque
            EXPECT_GE(moving.high, motor - 1e-15);
            EXPECT_GT(moving.low, low);  // more torque, more load
            EXPECT_GT(moving.high, high);
            low = moving.low;
            high = moving.high;
        }
    }
}

TEST(FrictionLaw, SlopeIsTheRightDerivative) {
    const double h = 1e-7;
    for (const auto& [name, law] : kLaws) {
        SCOPED_TRACE(name);
        for (double load = 0.0; load <= 2.6; load += 0.0507) {  // misses 2.5 Nm, where the falling table reaches 0
            const double rise = (law.at_rest(load + h) - law.at_rest(load)) / h;
            EXPECT_NEAR(law.slope(load), rise, 1e-5) << load;  // h times the curvature of a cubic between rows (to 20), and 1e-16/h
            EXPECT_EQ(law.slope(-load), law.slope(load));
        }
    }
}

TEST(FrictionLaw, AStraightTableIsTheAffineLaw) {
    const FrictionLaw affine = FrictionLaw::affine(0.04, 0.25, 0.2),
                      table = FrictionLaw::tabulated({0.1, 0.4, 1.0, 1.1}, {0.065, 0.14, 0.29, 0.315}, 0.2);
    for (double load = -3.0; load <= 3.0; load += 0.01) {
        EXPECT_NEAR(table.at_rest(load), affine.at_rest(load), 1e-15 * 4.0);
        EXPECT_NEAR(table.slope(load), affine.slope(load), 1e-13);
        EXPECT_NEAR(table.resting_loads(load).low, affine.resting_loads(load).low, 1e-14);
        EXPECT_NEAR(table.resting_loads(load).high, affine.resting_loads(load).high, 1e-13);
    }
}

/// Between rising rows a table rises: no bump that the rows do not have (Fritsch & Carlson 1980).
TEST(FrictionLaw, ATableIsAsMonotoneAsItsRows) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int i = 0; i < 300; ++i) {
        std::vector<double> loads{0.2 * unit(random)}, torques{0.1 * unit(random)};
        for (int row = 0; row < 8; ++row) {
            const double wide = 0.05 + unit(random);
            loads.push_back(loads.back() + wide);
            torques.push_back(torques.back() + (unit(random) < 0.3 ? 0.0 : 0.6 * wide * unit(random)));
        }
        const FrictionLaw law = FrictionLaw::tabulated(loads, torques);
        double earlier = 0.0;
        for (double load = loads.front(); load <= loads.back(); load += 0.01) {
            ASSERT_GE(law.at_rest(load), earlier - 1e-15) << i << " " << load;
            earlier = law.at_rest(load);
        }
    }
}

TEST(FrictionLawRefusal, BadNumbersAreNamed) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double mu : {-0.1, 0.96, nan}) EXPECT_EQ(field_refused([&] { return FrictionLaw::proportional(mu); }), "friction.mu");
    const auto affine = [](double constant, double mu, double rest_excess) {
        return field_refused([&] { return FrictionLaw::affine(constant, mu, rest_excess); });
    };
    EXPECT_EQ(affine(0.0, 0.7, 0.4), "friction.mu") << "0.98 at rest";
    EXPECT_EQ(affine(-0.01, 0.2, 0.0), "friction.constant");
    EXPECT_EQ(affine(0.0, 0.2, -0.1), "friction.rest_excess");
    using Column = std::vector<double>;
    const auto table = [](const Column& load, const Column& friction, double rest_excess = 0.0) {
        return field_refused([&] { return FrictionLaw::tabulated(load, friction, rest_excess); });
    };
    EXPECT_EQ(table({0.0, 1.0}, {0.0, 0.3}, nan), "friction.rest_excess");
    EXPECT_EQ(table({1.0}, {0.3}), "friction table");
    EXPECT_EQ(table({0.0, 1.0}, {0.0, 0.3, 0.4}), "friction table");
    EXPECT_EQ(table({-0.1, 1.0}, {0.0, 0.3}), "friction table, row 1: load_Nm");
    EXPECT_EQ(table({0.0, 1.0, 1.0}, {0.0, 0.3, 0.4}), "friction table, row 3: load_Nm");
    EXPECT_EQ(table({0.0, 1.0}, {0.0, -0.3}), "friction table, row 2: friction_Nm");
    EXPECT_EQ(table({0.0, 1.0, 2.0}, {0.0, 0.96, 1.0}), "friction table, row 2: friction_Nm");
    EXPECT_EQ(table({0.0, 1.0, 2.0}, {0.0, 0.2, 0.9}, 0.4), "friction table, row 3: friction_Nm");
    EXPECT_EQ(table({0.0, 1.0, 2.0, 3.0}, {0.1, 0.1, 0.9, 0.9}), "friction table, row 3: friction_Nm")
        << "no row rises by more than 0.8, but the cubic between level ends does";
}

}  // namespace
}  // namespace fusee::spring
