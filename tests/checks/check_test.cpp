#include "fusee/checks/check.h"

#include <gtest/gtest.h>

#include "checks/fixture.h"
#include "fusee/core/error.h"

namespace fusee::checks {
namespace {

TEST(Check, WorstPlaceIsNamed) {
    Fixture b = spool();
    b.part.cam.working[kRows / 2].path.rho = 1.5 * kMm;  // psi = 0, (11, 0)
    const core::Finding f = worst("cable.bend_ratio", b);
    ASSERT_TRUE(f.place);
    EXPECT_NEAR(f.place->angle, 0.0, 1e-12);
    EXPECT_NEAR(f.place->point_mm[0], 11.0, 1e-9);
    EXPECT_EQ(f.where, "k_se at psi 0.0 deg");
}

TEST(Check, APartMayBeTurnedToFitTheBuildVolume) {
    Fixture b = spool();
    b.process.build_x = 0.3, b.process.build_y = 0.1;
    b.part.mesh = box({0, 0, 0}, {90, 250, 10});
    EXPECT_EQ(worst("process.build_volume", b).severity, core::Severity::kPass);
}

TEST(Check, CallersMistakesAreNamed) {
    Fixture b = spool();
    b.cable.construction = "rope";
    try {
        (void)check(b.design());
        FAIL() << "an unknown construction passed";
    } catch (const core::InvalidInput& e) {
        EXPECT_EQ(e.field(), "cable.construction");
        EXPECT_NE(e.allowed().find("7x19"), std::string::npos);
    }
}

TEST(Check, ReportsInTheOrderOfTheRules) {
    std::size_t at = 0;
    for (const core::Finding& f : check(spool().design())) {
        while (at < rules().size() && f.rule != rules()[at].id) ++at;
        ASSERT_LT(at, rules().size()) << f.rule << " comes before an earlier rule";
    }
}

TEST(Check, WithoutMeshOnlyTheRulesThatNeedItAreLeftOut) {
    Fixture b = spool();
    const core::Findings all = check(b.design()), fewer = check_without_mesh(b.design());
    std::size_t at = 0;
    for (const core::Finding& f : all) {
        const Rule& rule = *std::find_if(rules().begin(), rules().end(), [&](const Rule& r) { return r.id == f.rule; });
        if (rule.needs_mesh) continue;
        ASSERT_LT(at, fewer.size());
        EXPECT_EQ(core::to_line(fewer[at++]), core::to_line(f));
    }
    EXPECT_EQ(at, fewer.size());
    EXPECT_LT(fewer.size(), all.size());
}

TEST(Check, RulesThatDoNotNeedAMeshDoNotLookAtIt) {
    Fixture with = spool(), without = spool();
    without.part.mesh = {};
    const core::Findings a = check_without_mesh(with.design()), b = check_without_mesh(without.design());
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(core::to_line(a[i]), core::to_line(b[i]));
}

TEST(Check, SameFindingsTwice) {
    const core::Findings first = check(pusher().design()), second = check(pusher().design());
    ASSERT_EQ(first.size(), second.size());
    for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(core::to_line(first[i]), core::to_line(second[i]));
}

}  // namespace
}  // namespace fusee::checks
