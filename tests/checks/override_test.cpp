#include <gtest/gtest.h>

#include <set>

#include "checks/fixture.h"

namespace fusee::checks {
namespace {

TEST(Override, StricterLimitsBindToo) {
    Fixture b = spool();
    b.overrides = {{"process.wall", "required_mm", 1.5, "a rough workshop"}};
    const core::Finding f = worst("process.wall", b);
    EXPECT_EQ(f.severity, core::Severity::kError);
    EXPECT_DOUBLE_EQ(f.allowed, 1.5);
    ASSERT_EQ(f.overridden.size(), 1u);
    EXPECT_DOUBLE_EQ(f.overridden[0].normal, 0.8);
    EXPECT_EQ(f.overridden[0].unit, "mm");
    EXPECT_NE(f.what.find("; the profile's required_mm = 1.5 mm instead of 0.8 mm: a rough workshop"), std::string::npos) << f.what;
    EXPECT_NE(f.suggestion.text().find("1.5"), std::string::npos) << "the suggestion keeps the profile's limit: " << f.suggestion.text();
}

TEST(Override, TouchesNoOtherRuleAndNoOtherLimit) {
    Fixture b = spool();
    b.overrides = {{"shaft.hub_wall", "required_mm", 0.1, "steel"}};
    const core::Findings before = check(spool().design()), after = check(b.design());
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(core::to_line(before[i]), core::to_line(after[i]));
    Fixture thin = with_screw();
    thin.part.options.hub.boss_diameter = 7.0 * kMm;
    thin.overrides = b.overrides;
    const core::Finding f = worst("shaft.hub_wall", thin);
    EXPECT_EQ(f.severity, core::Severity::kWarning) << "0.4 mm: the required limit is overridden, the loaded wall is still a warning";
    EXPECT_EQ(f.overridden.size(), 1u) << "and the finding names the override";
}

TEST(Override, JudgesWhatTheProfileLeftOpen) {
    Fixture b = spool();
    b.spring.max_state = 0.0;
    ASSERT_EQ(worst("spring.torsion_angle", b).severity, core::Severity::kNotJudged);
    b.overrides = {{"spring.torsion_angle", "required_rad", 5.0, "measured set"}};
    const core::Finding f = worst("spring.torsion_angle", b);
    EXPECT_EQ(f.severity, core::Severity::kError);
    EXPECT_NE(f.what.find("where the rule has none"), std::string::npos) << f.what;
}

TEST(Override, EveryLimitHasOneName) {
    for (const Rule& rule : rules()) {
        std::set<std::string> keys;
        EXPECT_FALSE(rule.limits.empty()) << rule.id;
        for (const Limit& limit : rule.limits) {
            EXPECT_TRUE(keys.insert(limit.key()).second) << rule.id << ' ' << limit.key();
            EXPECT_EQ(limit.key().find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_"), std::string::npos)
                << rule.id << ' ' << limit.key();
            EXPECT_EQ(rule.limit(limit.key()), &limit);
            EXPECT_EQ(std::isnan(limit.value), !limit.by.empty()) << rule.id;
        }
        EXPECT_NE(std::string(rule.measures), "") << rule.id;
        EXPECT_NE(std::string(group_title(rule.group())), "") << rule.id;
    }
}

}  // namespace
}  // namespace fusee::checks
