#include "fusee/report/headline.h"

#include <cmath>

#include "fusee/report/rule_counts.h"
#include "page_structure.h"

namespace fusee::report {
namespace {

core::Finding of_rule(const char* rule, core::Severity severity) {
    core::Finding f;
    f.rule = rule;
    f.severity = severity;
    return f;
}

core::Findings mixed() {
    return {of_rule("cable.pressure", core::Severity::kNotJudged), of_rule("spring.stress", core::Severity::kNotJudged),
            of_rule("spring.load", core::Severity::kPass),         of_rule("spring.rod", core::Severity::kNotJudged),
            of_rule("shaft.key", core::Severity::kWarning),        of_rule("cable.knot", core::Severity::kError)};
}

TEST(RuleCounts, AreGroupedInTheirOrder) {
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

TEST(RuleCounts, TheTextBeginsWithTheLargestGroup) {
    EXPECT_EQ(not_judged_text(mixed()), "3 rules not judged: spring 2, cable 1");
    EXPECT_EQ(not_judged_text({of_rule("mesh.self_intersection", core::Severity::kNotJudged)}), "1 rule not judged: mesh 1");
    EXPECT_EQ(not_judged_text({of_rule("spring.load", core::Severity::kPass)}), "");
}

/// A dead-band of 1 rad that falls to 0.5 rad; arms of 3 and 8 mm within 0.3 mm.
Headline printed_design() {
    Headline o;
    o.process = "fdm";
    o.arms = {{"k_se", 0.3, 8.0}, {"k_pe", 0.3, 3.0}};
    o.least = {0.85, 1.0, {0.9, 1.1}};
    o.overdrive = {1.5, 0.5, {0.4, 0.6}};
    o.joint_torque = 0.1508;
    o.condition = {.torques = {0.85, 1.5}, .holds = {{0.85, 1.5}}, .values = {-2e-6, -6e-7}};
    return o;
}

TEST(HeadFigures, BeginWithTheDeadBandAndTheArms) {
    const auto all = head_figures(printed_design(), {3.2e-4, 2.7e-4});
    ASSERT_EQ(all.size(), 4u);
    EXPECT_EQ(all[0].value, "57.3 to 28.6 deg");
    expect_all(all[0].label, {"from 0.85 Nm to 1.5 Nm", "51.6 to 63 deg at 0.85 Nm, 22.9 to 34.4 deg at 1.5 Nm"});
    EXPECT_EQ(all[0].name, "Dead-band, 0.85 to 1.5 Nm");
    EXPECT_EQ(all[0].line, "as built: 51.6 to 63, 22.9 to 34.4 deg");
    EXPECT_EQ(all[1].name, "Lever arms as built");
    EXPECT_EQ(all[1].value, "-10 to +10 %") << "0.3 mm on the least arm of 3 mm";
    expect_all(all[1].label, {"fdm", "0.3 mm", "k_se", "8 mm", "k_pe", "3 mm", "0.032 %", "0.027 %"});
    EXPECT_EQ(all[2].value, "0.151 Nm");
    EXPECT_EQ(all[3].value, "within rounding (-2e-06 to -6e-07)");
}

// Sampled bands are the ones to believe: they are quoted where joints were sampled, and the label says which it is.
TEST(HeadFigures, QuoteTheSampledBandWhereJointsWereSampled) {
    Headline o = printed_design();
    o.budget.emplace().parts.resize(2);
    for (design::budget::PartBudget& part : o.budget->parts) part.places = {design::budget::TorqueError{}};
    design::budget::TorqueError& worst = o.budget->parts[0].places.front();
    worst.sigma[0] = 0.08, worst.band = {-0.136, 0.136}, worst.sampled = {-0.117, 0.109};
    EXPECT_EQ(head_figures(o, {})[1].value, "-13.6 to +13.6 %");
    expect_all(head_figures(o, {})[1].label, {"5 to 95 % of joints, first order"});
    o.budget->draws = 200;
    EXPECT_EQ(head_figures(o, {})[1].value, "-11.7 to +10.9 %");
    expect_all(head_figures(o, {})[1].label, {"5 to 95 % of 200 sampled joints"});
    expect_all(head_figures(o, {})[0].label, {"of 200 sampled joints as built"});
}

TEST(HeadFigures, UnknownFiguresAreNamedOrLeftOut) {
    Headline o = printed_design();
    o.least.nominal = o.joint_torque = std::nan("");
    o.least.built = {std::nan(""), std::nan("")};
    const auto all = head_figures(o, {});
    EXPECT_EQ(all[0].value, "not covered by the springs at 0.85 Nm, 28.6 deg at 1.5 Nm");
    for (const HeadFigure& figure : all) expect_none(figure.value + figure.label, {"nan", "\u2013"});
    EXPECT_TRUE(head_figures(Headline{}, {1e-4, 1e-4}).empty());
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

TEST(Condition, TheTextStatesTheMargin) {
    expect_all(condition_text(condition(-0.2, -0.1)), {"holds from 0.5 Nm to 1 Nm: d(T tau_f)/dtau is -0.2 to -0.1"});
    expect_all(condition_text(condition(-2e-6, -6e-7)), {"within rounding", "from 0.5 Nm to 1 Nm", "-2e-06 to -6e-07"});
}

}  // namespace
}  // namespace fusee::report
