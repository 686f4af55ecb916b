#include "checks/known_bad.h"

#include <gtest/gtest.h>

#include <set>

// Known: every rule is broken by a part with a value computed by hand, and by nothing in that part's good twin.
namespace fusee::checks {
namespace {

/// Every rule that does not pass, with its text.
std::set<std::string> objections(const Fixture& fixture, std::string& said) {
    std::set<std::string> ids;
    for (const core::Finding& f : check(fixture.design())) {
        if (!core::is_broken(f)) continue;
        ids.insert(f.rule);
        said += core::to_line(f) + "\n";
    }
    return ids;
}

class KnownBad : public testing::TestWithParam<Case> {};

TEST_P(KnownBad, TripsTheRule) {
    const core::Finding f = worst(GetParam().rule, bad(GetParam()));
    EXPECT_EQ(f.severity, GetParam().severity) << core::to_line(f);
    EXPECT_NEAR(f.measured, GetParam().measured, GetParam().tolerance) << core::to_line(f);
    EXPECT_NEAR(f.allowed, GetParam().allowed, std::max(1e-6, GetParam().tolerance)) << core::to_line(f);
    EXPECT_EQ(f.rule, GetParam().rule);
    EXPECT_NE(f.suggestion.text().find_first_of("0123456789"), std::string::npos) << "a change has a number: " << f.suggestion.text();
    for (const char* none : {"nan", "inf"}) EXPECT_EQ(f.suggestion.text().find(none), std::string::npos) << f.suggestion.text();
    EXPECT_FALSE(f.what.empty());
    EXPECT_FALSE(f.source.empty());
    EXPECT_TRUE(f.where.starts_with("k_se") || f.where.starts_with("k_pe")) << f.where;
}

TEST_P(KnownBad, TripsNoOther) {
    std::set<std::string> expected{GetParam().rule};
    for (const char* other : GetParam().also) expected.insert(other);
    std::string said;
    EXPECT_EQ(objections(bad(GetParam()), said), expected) << said;
}

TEST_P(KnownBad, GoodTwinPassesEveryRule) {
    std::string said;
    EXPECT_TRUE(objections(GetParam().twin(), said).empty()) << said;
}

/// An override that allows the measured value removes the finding; the text names the override.
TEST_P(KnownBad, AnOverriddenLimitHolds) {
    Fixture b = bad(GetParam());
    const core::Finding broken = worst(GetParam().rule, b);
    for (const Limit& limit : find_rule(GetParam().rule)->limits)
        if (limit.unit == broken.unit && limit.bound == broken.bound)
            b.overrides.push_back({GetParam().rule, limit.key(), broken.measured, "our machine makes it"});
    ASSERT_FALSE(b.overrides.empty()) << "no declared limit in " << broken.unit;
    bool said = false;
    for (const core::Finding& f : run_rule(GetParam().rule, b)) {
        EXPECT_EQ(f.severity, core::Severity::kPass) << core::to_line(f);
        if (f.overridden.empty()) continue;
        said = true;
        EXPECT_EQ(f.overridden.front().value, broken.measured);
        EXPECT_EQ(f.overridden.front().reason, "our machine makes it");
        EXPECT_NE(f.what.find("our machine makes it"), std::string::npos) << f.what;
    }
    EXPECT_TRUE(said);
}

std::string test_name(const testing::TestParamInfo<Case>& instance) {
    std::string name = std::string(instance.param.rule) + "_" + instance.param.name;
    std::erase_if(name, [](char c) { return c == ' ' || c == '%'; });
    std::replace(name.begin(), name.end(), '.', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Rules, KnownBad, testing::ValuesIn(all_cases()), test_name);

TEST(Rules, EachHasAKnownBadPartThatTripsItAlone) {
    std::set<std::string> alone;
    for (const Case& c : all_cases())
        if (c.also.empty()) alone.insert(c.rule);
    for (const Rule& rule : rules()) EXPECT_TRUE(alone.count(rule.id)) << rule.id;
    EXPECT_GE(rules().size(), 60u);
}

TEST(Rules, EachSeverityIsMetByAKnownBadPart) {
    std::set<std::pair<std::string, core::Severity>> met;
    for (const Case& c : all_cases()) met.emplace(c.rule, c.severity);
    for (const Rule& rule : rules()) EXPECT_TRUE(met.count({rule.id, rule.severity()})) << rule.id;
}

}  // namespace
}  // namespace fusee::checks
