#include <gtest/gtest.h>

#include <cmath>

#include "fusee/report/outlook.h"
#include "fusee/report/rule_counts.h"

namespace fusee::report {
namespace {

core::Finding of(const char* rule, core::Severity severity) {
    core::Finding f;
    f.rule = rule;
    f.severity = severity;
    return f;
}

core::Findings mixed() {
    return {of("cable.pressure", core::Severity::kNotJudged), of("spring.stress", core::Severity::kNotJudged),
            of("spring.load", core::Severity::kPass),         of("spring.rod", core::Severity::kNotJudged),
            of("shaft.key", core::Severity::kWarning),        of("cable.knot", core::Severity::kError)};
}

TEST(RuleCounts, ByGroupInOrder) {
    const auto counts = count_rules(mixed());
    ASSERT_EQ(counts.size(), 3u);
    EXPECT_EQ(counts[0].group, "cable");
    EXPECT_EQ(counts[0].not_judged, 1u);
    EXPECT_EQ(counts[0].required, 1u);
    EXPECT_EQ(counts[1].group, "spring");
    EXPECT_EQ(counts[1].not_judged, 2u);
    EXPECT_EQ(counts[1].passed, 1u);
    EXPECT_EQ(counts[2].review, 1u);
}

TEST(RuleCounts, SayWhatWasNotJudgedTheMostFirst) {
    EXPECT_EQ(not_judged_text(mixed()), "3 rules not judged: spring 2, cable 1");
    EXPECT_EQ(not_judged_text({of("mesh.self_intersection", core::Severity::kNotJudged)}), "1 rule not judged: mesh 1");
    EXPECT_EQ(not_judged_text({of("spring.load", core::Severity::kPass)}), "");
}

/// A dead-band of 1 rad that falls to 0.5 rad; arms of 3 and 8 mm within 0.3 mm.
Outlook example() {
    Outlook o;
    o.process = "fdm";
    o.arms = {{"k_se", 0.3, 8.0}, {"k_pe", 0.3, 3.0}};
    o.least = {0.85, 1.0, {0.9, 1.1}};
    o.overdrive = {1.5, 0.5, {0.4, 0.6}};
    o.joint_torque = 0.1508;
    o.condition = {.torques = {0.85, 1.5}, .holds = {{0.85, 1.5}}, .values = {-2e-6, -6e-7}};
    return o;
}

TEST(HeadFigures, LeadWithWhatTheUserGets) {
    const auto all = head_figures(example(), {3.2e-4, 2.7e-4});
    ASSERT_EQ(all.size(), 4u);
    EXPECT_EQ(all[0].value, "57.3 to 28.6 deg");
    EXPECT_EQ(all[0].label,
              "dead-band at the joint, exact, from 0.85 Nm to 1.5 Nm of co-contraction; 5 to 95 % of joints as built: 51.6 to 63 deg at "
              "0.85 Nm, 22.9 to 34.4 deg at 1.5 Nm");
    EXPECT_EQ(all[1].value, "-10 to +10 %") << "0.3 mm at the least arm of 3 mm";
    EXPECT_EQ(
        all[1].label,
        "arm error expected of the parts by fdm: 0.3 mm at the least arm of k_se, 8 mm, 0.3 mm at the least arm of k_pe, 3 mm; of the "
        "files 0.032 %, their dead-band within 0.027 %");
    EXPECT_EQ(all[2].value, "0.151 Nm");
    EXPECT_EQ(all[3].value, "within rounding (-2e-06 to -6e-07)");
}

TEST(HeadFigures, WhatIsNotKnownIsSaidInWordsOrLeftOut) {
    Outlook o = example();
    o.least.nominal = o.joint_torque = std::nan("");
    o.least.built = {std::nan(""), std::nan("")};
    const auto all = head_figures(o, {});
    EXPECT_EQ(all[0].value, "not covered by the springs at 0.85 Nm, 28.6 deg at 1.5 Nm");
    for (const HeadFigure& figure : all)
        for (const char* none : {"nan", "\u2013"}) EXPECT_EQ((figure.value + figure.label).find(none), std::string::npos) << figure.label;
    EXPECT_TRUE(head_figures(Outlook{}, {1e-4, 1e-4}).empty());
}

actuator::ConditionSummary condition(double low, double high) {
    actuator::ConditionSummary c{.torques = {0.5, 1.0}, .holds = {}, .values = {low, high}};
    if (low < 0.0) c.holds = {{0.5, high < 0.0 ? 1.0 : 0.7}};
    return c;
}

TEST(Condition, HoldsOnlyBeyondRounding) {
    EXPECT_EQ(condition_verdict(condition(-0.2, -0.1)), ConditionVerdict::kHolds);
    EXPECT_EQ(condition_verdict(condition(0.1, 0.2)), ConditionVerdict::kFails);
    EXPECT_EQ(condition_verdict(condition(-0.1, 0.2)), ConditionVerdict::kMixed);
    EXPECT_EQ(condition_verdict(condition(-2e-6, -6e-7)), ConditionVerdict::kWithinRounding);
    EXPECT_EQ(condition_verdict(condition(-0.2, -2e-6)), ConditionVerdict::kWithinRounding) << "at its weakest place";
    EXPECT_EQ(condition_verdict(condition(1e-6, 2e-6)), ConditionVerdict::kWithinRounding) << "the stiction stays the same";
    EXPECT_EQ(condition_verdict(condition(std::nan(""), std::nan(""))), ConditionVerdict::kNotKnown);
}

TEST(Condition, TextStatesTheMargin) {
    EXPECT_NE(condition_text(condition(-0.2, -0.1)).find("holds from 0.5 Nm to 1 Nm: d(T tau_f)/dtau is -0.2 to -0.1"), std::string::npos);
    const std::string slight = condition_text(condition(-2e-6, -6e-7));
    EXPECT_NE(slight.find("within rounding only from 0.5 Nm to 1 Nm: d(T tau_f)/dtau is -2e-06 to -6e-07"), std::string::npos) << slight;
    EXPECT_EQ(slight.find("holds"), std::string::npos) << slight;
}

}  // namespace
}  // namespace fusee::report
