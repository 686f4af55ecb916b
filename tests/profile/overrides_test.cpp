#include "fusee/core/units.h"
#include "profile/fixture.h"

namespace fusee::profile {
namespace {

class OverridesTest : public ProfileTest {
protected:
    /// The valid profile with one [[limits]] behind it; its heading is line 27.
    static std::string with(const std::string& body) { return std::string(kShort) + "[[limits]]\n" + body; }
};

TEST_F(OverridesTest, AreReadInOrder) {
    const Profile p =
        read(with("rule = \"process.wall\"\nrequired_mm = 0.6\nreason = \"our printer does it\"\n"
                  "[[limits]]\nrule = \"cable.fleet\"\nrequired_deg = 5\nreview_deg = 3.0\nreason = \"ferrule\"\n"));
    ASSERT_EQ(p.limits.size(), 3u);
    EXPECT_EQ(p.limits[0].rule, "process.wall");
    EXPECT_EQ(p.limits[0].limit, "required_mm");
    EXPECT_EQ(p.limits[0].value, 0.6);
    EXPECT_EQ(p.limits[0].reason, "our printer does it");
    EXPECT_EQ(p.limits[1].limit, "required_deg");
    EXPECT_EQ(p.limits[1].value, 5.0);
    EXPECT_EQ(p.limits[2].limit, "review_deg");
    EXPECT_TRUE(read(kShort).limits.empty());
}

TEST_F(OverridesTest, WrittenAndReadAgainGiveTheSame) {
    const std::string text =
        to_toml(read(with("rule = \"groove.radius\"\nlow_review_d = 0.51\nhigh_review_d = 1e-05\nreason = 'the \"thin\" one'\n")));
    EXPECT_EQ(to_toml(read(text)), text);
    expect_words(text, {"[[limits]]\nrule = \"groove.radius\"\n", "low_review_d = 0.51\nreason = \"the \\\"thin\\\" one\"\n"});
}

TEST_F(OverridesTest, UnknownRuleNamesTheNearest) {
    expect_words(refusal(with("rule = \"proces.wall\"\nrequired_mm = 0.6\nreason = \"x\"\n")),
                 {"p.toml:28:8: limits.rule", "unknown rule \"proces.wall\"", "process.wall"});
    expect_words(refusal(with("rule = 3\nrequired_mm = 0.6\nreason = \"x\"\n")), {"p.toml:28:8: limits.rule", "the id of a rule"});
    expect_words(refusal(with("required_mm = 0.6\nreason = \"x\"\n")), {"p.toml:27:1: limits.rule: missing"});
}

TEST_F(OverridesTest, MissingOrEmptyReason) {
    expect_words(refusal(with("rule = \"process.wall\"\nrequired_mm = 0.6\n")), {"p.toml:27:1: limits.reason: missing", "the reason"});
    expect_words(refusal(with("rule = \"process.wall\"\nrequired_mm = 0.6\nreason = \" \"\n")),
                 {"p.toml:30:10: limits.reason", "the reason"});
    expect_words(refusal(with("rule = \"process.wall\"\nrequired_mm = 0.6\nreason = 5\n")), {"p.toml:30:10: limits.reason"});
}

TEST_F(OverridesTest, WrongUnitOrLimitNamesThoseThatTheRuleHas) {
    expect_words(refusal(with("rule = \"process.wall\"\nrequired_deg = 0.6\nreason = \"x\"\n")),
                 {"p.toml:29:1: limits.required_deg", "not the unit of this limit", "process.wall has required_mm"});
    expect_words(refusal(with("rule = \"process.wall\"\nrequired = 0.6\nreason = \"x\"\n")),
                 {"p.toml:29:1: limits.required", "not the unit of this limit", "required_mm"});
    expect_words(refusal(with("rule = \"process.wall\"\nlimit = 0.6\nreason = \"x\"\n")),
                 {"p.toml:29:1: limits.limit", "unknown limit", "required_mm"});
    expect_words(refusal(with("rule = \"process.wall\"\nreason = \"x\"\n")), {"p.toml:27:1: limits.rule", "no limit", "required_mm"});
}

TEST_F(OverridesTest, LimitsAreFiniteNumbersOnce) {
    for (const char* value : {"nan", "inf", "-inf", "\"0.6\"", "true", "[0.6]"})
        expect_words(refusal(with("rule = \"process.wall\"\nreason = \"x\"\nrequired_mm = " + std::string(value) + "\n")),
                     {"p.toml:30:15: limits.required_mm", "a finite number in mm"});
    expect_words(refusal(with("rule = \"process.wall\"\nrequired_mm = 0.6\nreason = \"x\"\n"
                              "[[limits]]\nrule = \"process.wall\"\nrequired_mm = 0.7\nreason = \"y\"\n")),
                 {"p.toml:33:1: limits.required_mm", "is repeated"});
}

TEST_F(OverridesTest, OnlyAnArrayOfTables) {
    expect_words(refusal(std::string(kShort) + "[limits]\nrule = \"process.wall\"\n"), {"p.toml:27:1: limits", "[[limits]]"});
    expect_words(refusal("limits = 3\n" + std::string(kShort)), {"p.toml:1:10: limits", "[[limits]]"});
    expect_words(refusal("limits = []\n" + std::string(kShort)), {"p.toml:1:10: limits", "[[limits]]"});
}

}  // namespace
}  // namespace fusee::profile
