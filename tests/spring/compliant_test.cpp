#include <gtest/gtest.h>

#include <cmath>

#include "fusee/core/error.h"
#include "fusee/spring/laws.h"
#include "fusee/spring/potential.h"
#include "refused.h"

namespace fusee::spring {
namespace {

PotentialPtr curved() {
    return series_spring(*make_stiction_law({.k = 0.225, .u = 0.0012, .c = 0.265, .mu = 0.28, .start_torque = 0.6, .end_torque = 2.1}));
}

// Known: two straight springs in series, 1/S = 1/s + c, and the preload at the lower end is kept. A straight line up to 2 rad of the
// spring.
TEST(Compliant, TwoStraightSpringsInSeries) {
    const PotentialPtr one = resampled(make_built_spring(make_polynomial({0.3, 0.2}), {.rate = 0.02, .preload = 3.0}, 0.03, {}));
    const PotentialPtr two = with_compliance(one, 5.0);
    EXPECT_NEAR(two->force(0.0), 0.3, 1e-12);
    for (const double x : {0.0, 0.4, 1.7}) {
        EXPECT_NEAR(two->force(x), 0.3 + 0.1 * x, 1e-10) << x;
        EXPECT_NEAR(two->stiffness(x), 0.1, 1e-9) << x;
        EXPECT_NEAR(two->slope(x), 0.0, 1e-6) << x;
    }
}

// Law: force and its derivatives are those of the energy. Central differences of step 1e-5 rad are off by 1e-9 of the values here.
TEST(Compliant, DerivativesAgreeWithTheEnergy) {
    const PotentialPtr soft = with_compliance(curved(), 0.4);
    const core::Range domain = soft->domain();
    constexpr double kStep = 1e-5;
    for (const double share : {0.1, 0.5, 0.9}) {
        const double x = std::lerp(domain.low, domain.high, share);
        EXPECT_NEAR((soft->energy(x + kStep) - soft->energy(x - kStep)) / (2 * kStep), soft->force(x), 1e-7) << x;
        EXPECT_NEAR((soft->force(x + kStep) - soft->force(x - kStep)) / (2 * kStep), soft->stiffness(x), 1e-7) << x;
        EXPECT_NEAR((soft->stiffness(x + kStep) - soft->stiffness(x - kStep)) / (2 * kStep), soft->slope(x), 1e-5) << x;
    }
}

// What is put in and taken away again leaves the spring: rounding alone.
TEST(Compliant, IsTakenAwayAgain) {
    const PotentialPtr spring = curved(), same = with_compliance(with_compliance(spring, 0.3), -0.3);
    EXPECT_NEAR(same->domain().high, spring->domain().high, 1e-12);
    for (const double share : {0.0, 0.3, 1.0}) {
        const double x = share * spring->domain().high;
        EXPECT_NEAR(same->force(x), spring->force(x), 1e-10);
        EXPECT_NEAR(same->stiffness(x), spring->stiffness(x), 1e-8);
    }
    EXPECT_EQ(with_compliance(spring, 0.0), spring);
}

TEST(Compliant, RefusesToBecomeStifferThanRigid) {
    const double stiffest = curved()->stiffness(curved()->domain().high);
    EXPECT_EQ(field_refused([&] { return with_compliance(curved(), -1.01 / stiffest); }), "compliance");
    EXPECT_NO_THROW((void)with_compliance(curved(), -0.99 / stiffest));
}

}  // namespace
}  // namespace fusee::spring
