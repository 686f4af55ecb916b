#include "fusee/core/finding.h"

#include <gtest/gtest.h>

#include <limits>

namespace fusee::core {
namespace {

Finding bend(double measured) {
    Finding f;
    f.rule = "cable.bend_ratio";
    f.measured = measured;
    f.allowed = 8.0;
    f.suggestion = "a thinner cable";
    return f;
}

TEST(Finding, PassesOnTheBoundAndDropsItsSuggestion) {
    const Finding f = judged(bend(8.0), Severity::kError);
    EXPECT_EQ(f.severity, Severity::kPass);
    EXPECT_TRUE(f.suggestion.empty());
}

TEST(Finding, BrokenOrNotANumberGetsTheSeverity) {
    EXPECT_EQ(judged(bend(7.9), Severity::kWarning).severity, Severity::kWarning);
    EXPECT_EQ(judged(bend(std::numeric_limits<double>::quiet_NaN()), Severity::kError).severity, Severity::kError);
    EXPECT_TRUE(any_error({judged(bend(1.0), Severity::kError)}));
    EXPECT_FALSE(any_error({judged(bend(1.0), Severity::kWarning)}));
}

TEST(Finding, LineNamesRuleMeasuredAllowedAndChange) {
    const std::string line = to_line(judged(bend(6.0), Severity::kError));
    for (const char* word : {"error: ", "cable.bend_ratio", "6", "at least 8", "a thinner cable"})
        EXPECT_NE(line.find(word), std::string::npos) << word << " in " << line;
}

TEST(Finding, LineNeverShowsAMissedLimitAsEqual) {
    Finding f = bend(18.0 - 2e-6);
    f.allowed = 18.0;
    const std::string line = to_line(judged(f, Severity::kError));
    EXPECT_NE(line.find("measured 17.999998, allowed at least 18"), std::string::npos) << line;
}

TEST(Finding, UnjudgedRuleNamesWhatIsMissing) {
    const Finding f = not_judged("spring.stress", "the base spring's wire yielding", "k_se.spring.wire_diameter_mm");
    EXPECT_EQ(f.severity, Severity::kNotJudged);
    EXPECT_FALSE(is_broken(f));
    EXPECT_FALSE(any_error({f}));
    EXPECT_EQ(count({f, judged(bend(9.0), Severity::kWarning)}, Severity::kNotJudged), 1u);
    EXPECT_EQ(to_line(f), "not judged: spring.stress: the base spring's wire yielding; missing: k_se.spring.wire_diameter_mm");
}

TEST(Outcome, HoldsAValueOrARefusal) {
    const Outcome<int> good = 3;
    const Outcome<int> bad = judged(bend(1.0), Severity::kError);
    EXPECT_TRUE(good);
    EXPECT_EQ(*good, 3);
    EXPECT_FALSE(bad);
    EXPECT_EQ(bad.refusal().front().rule, "cable.bend_ratio");
}

}  // namespace
}  // namespace fusee::core
