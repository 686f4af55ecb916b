// The private header is tested directly: its answers are compared with an independent algorithm.
#include <gtest/gtest.h>

#include "codesign/shape.h"
#include "fusee/actuator/dead_band.h"
#include "fusee/spring/law.h"
#include "fusee/spring/laws.h"

namespace fusee::search::codesign {
namespace {

spring::SpringLawPtr law_up_to(double end) {
    return *spring::with_lead_in(*spring::make_stiction_law({0.225, 0.0012, 0.265, 0.28, 0.6, end}), 0.05);
}

TEST(Edges, EqualTheNestedRootsWhereTheLawReaches) {
    const actuator::Actuator joint{law_up_to(2.3), 0.03, 0.045, spring::FrictionLaw::proportional(0.28), 0.85, 1.0, 1.5};
    for (double torque = 0.86; torque < 1.55; torque += 0.03) {
        const auto edges = find_edges(*joint.law, joint.gear_friction.resting_loads(torque));
        ASSERT_TRUE(edges);
        EXPECT_NEAR(edges->width(joint.ratio()), actuator::dead_band(joint, torque).exact_width, 1e-10) << torque;
    }
}

TEST(Edges, AShortLawTellsByHowMuchItIsShort) {
    const core::Range loads = spring::FrictionLaw::proportional(0.28).resting_loads(1.5);
    double before = 1e9;
    for (const double end : {1.9, 2.0, 2.1, 2.15}) {
        const auto law = law_up_to(end);
        const auto edges = find_edges(*law, loads);
        ASSERT_TRUE(edges);
        const double lacking = edges->high - law->angles().high;
        EXPECT_GT(lacking, 0.0) << end;
        EXPECT_LT(lacking, before) << end;
        before = lacking;
    }
    // docs/theory/dead_band.md: the law has to go on to 2.204 Nm.
    for (const double end : {2.205, 2.3}) {
        const auto law = law_up_to(end);
        EXPECT_LE(find_edges(*law, loads)->high, law->angles().high) << end;
    }
}

TEST(Edges, NoWidthWithoutFriction) {
    const auto edges = find_edges(*law_up_to(2.3), {1.0, 1.0});
    ASSERT_TRUE(edges);
    EXPECT_NEAR(edges->width(1.0), 0.0, 1e-12);
}

}  // namespace
}  // namespace fusee::search::codesign
