#include <nlohmann/json.hpp>

#include "app/run.h"

namespace fusee::app {
namespace {

using Json = nlohmann::json;

TEST_F(Program, ListsRulesAsJson) {
    const Ended ended = run("rules --json");
    ASSERT_EQ(ended.code, 0);
    const Json rules = result_of(ended);
    ASSERT_GE(rules.size(), 60u);
    const std::string text = run("rules").out;
    for (const Json& rule : rules) {
        for (const char* key : {"rule", "group", "severity", "guards_against", "measured", "source"})
            EXPECT_FALSE(rule.at(key).get<std::string>().empty()) << rule.dump();
        EXPECT_TRUE(rule.at("rule").get<std::string>().starts_with(rule.at("group").get<std::string>() + "."));
        EXPECT_NE(text.find("\n  " + rule.at("rule").get<std::string>() + " "), std::string::npos) << rule.at("rule");
        for (const Json& limit : rule.at("limits")) {
            EXPECT_TRUE(limit.contains("default") != limit.contains("default_by")) << rule.dump();
            EXPECT_NE(text.find(limit.at("limit").get<std::string>() + " " + limit.at("bound").get<std::string>()), std::string::npos);
        }
    }
}

TEST_F(Program, AnOverriddenLimitStandsInTheReport) {
    write("t.toml", core::read_file(fixtures::shipped("pnrvsa")) +
                        "\n[[limits]]\nrule = \"fdm.support\"\nreview_mm2 = 300\nreason = \"soluble supports\"\n");
    const Ended made = run("make t.toml");
    ASSERT_EQ(made.code, 0) << made.all();
    EXPECT_EQ(made.out.find("fdm.support"), std::string::npos) << "allowed now, so there is nothing to review: " << made.out;
    const Json report = Json::parse(core::read_file(folder_ / "out" / "pnrvsa" / "report.json"));
    bool found = false;
    for (const Json& part : report.at("parts"))
        for (const Json& f : part.at("findings")) {
            if (f.at("rule") != "fdm.support") continue;
            found = true;
            EXPECT_EQ(f.at("severity"), "pass");
            const Json expected = {
                {"limit", "review_mm2"}, {"value", 300.0}, {"default", 25.0}, {"unit", "mm^2"}, {"reason", "soluble supports"}};
            EXPECT_EQ(f.at("overridden"), Json::array({expected}));
            EXPECT_NE(f.at("what").get<std::string>().find("soluble supports"), std::string::npos);
        }
    EXPECT_TRUE(found);
}

TEST_F(Program, AWrongOverrideIsBadInput) {
    write("t.toml",
          core::read_file(fixtures::shipped("pnrvsa")) + "\n[[limits]]\nrule = \"process.wal\"\nrequired_mm = 1\nreason = \"x\"\n");
    const Ended wrong = run("make t.toml");
    EXPECT_EQ(wrong.code, 2);
    expect_words(wrong.err, {"t.toml:", "limits.rule", "process.wall"});
}

}  // namespace
}  // namespace fusee::app
