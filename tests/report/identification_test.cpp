#include "fusee/report/identification.h"

#include <nlohmann/json.hpp>

#include "page_structure.h"

namespace fusee::report {
namespace {

/// Friction 0.25 times the load, 2 % more or less in turn; two repeats.
Identification identified(const std::vector<std::string>& sides) {
    std::vector<gap_case::BreakAway> rows;
    double more = 0.02;
    for (const std::string& side : sides)
        for (const double motor : {0.2, 0.5, 0.9, 1.4})
            for (const bool backdrive : {true, true, false, false})
                rows.push_back({side, backdrive, motor, motor / (1.0 - (backdrive ? 1.0 : -1.0) * 0.25 * (1.0 + (more = -more)))});
    return {"break_away", "0123456789abcdef", gap_case::identify_friction(rows)};
}

TEST(IdentificationJson, HoldsWhatWasFound) {
    const Identification found = identified({"agonist", "antagonist"});
    const auto j = nlohmann::json::parse(identification_json(found));
    EXPECT_EQ(j["name"], "break_away");
    EXPECT_EQ(j["lines"].size(), 9u);
    EXPECT_EQ(j["lines"][0]["mu"].get<double>(), found.friction.lines[0].mu);
    EXPECT_EQ(j["lines"][0]["mu_95"][1].get<double>(), found.friction.lines[0].mu_95.high);
    EXPECT_EQ(j["law"]["gear_friction"].get<double>(), found.friction.law->mu);
    EXPECT_EQ(j["repeats"].size(), 16u);
    EXPECT_EQ(j["remarks"][0]["id"], "constant");
}

TEST(IdentificationHtml, HoldsTheJsonWithTheLineOfFigure8) {
    const Identification found = identified({"<b>", "other"});
    expect_shell(identification_html(found), "identification", identification_json(found), identification_text(found));
    const auto j = nlohmann::json::parse(identification_json(found));
    EXPECT_EQ(j["trusted"]["mu"], found.friction.trusted().mu);
    EXPECT_EQ(j["line_curve"]["load_Nm"].size(), 61u);
    EXPECT_GE(j["line_curve"]["low_Nm"][0], 0.0) << "friction is not negative";
    EXPECT_TRUE(holds(j["profile_lines"], "gear_friction = 0.2"));
}

TEST(IdentificationText, EndsWithTheProfilesLines) {
    const std::string text = identification_text(identified({"agonist"}));
    EXPECT_NE(text.find("\nbackdrive "), std::string::npos);
    EXPECT_NE(text.find("[rig]\ngear_friction = 0.2"), std::string::npos);
    EXPECT_EQ(text.find("constant_Nm ="), std::string::npos);
}

}  // namespace
}  // namespace fusee::report
