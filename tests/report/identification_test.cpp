#include "fusee/report/identification.h"

#include <nlohmann/json.hpp>

#include "page_structure.h"

namespace fusee::report {
namespace {

/// Friction 0.25 times the load, 2 % more or less in turn; two repeats.
Identification identified(const std::vector<std::string>& sides) {
    std::vector<identification::BreakAway> rows;
    double more = 0.02;
    for (const std::string& side : sides)
        for (const double motor : {0.2, 0.5, 0.9, 1.4})
            for (const bool backdrive : {true, true, false, false})
                rows.push_back({side, backdrive, motor, motor / (1.0 - (backdrive ? 1.0 : -1.0) * 0.25 * (1.0 + (more = -more)))});
    return {"break_away", "0123456789abcdef", identification::identify_friction(rows)};
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

TEST(IdentificationHtml, ShowsFigure8AndEscapesNames) {
    const std::string page = identification_html(identified({"<b>", "other"}));
    EXPECT_EQ(occurrences(page, "<circle class=\"dot"), 2 * (16u + 4u));  // two pictures: a dot for each repeat, four keys
    EXPECT_EQ(occurrences(page, "class=\"band"), 1u);
    EXPECT_NE(page.find("gear_friction = 0.2"), std::string::npos);
    EXPECT_FALSE(holds(page, "<b> drive"));
    expect_page(page);
}

TEST(IdentificationHtml, ManyMotorsShareTwoColours) {
    std::vector<std::string> sides;
    for (int i = 0; i < 300; ++i) sides.push_back("motor " + std::to_string(i));
    const std::string page = identification_html(identified(sides));
    EXPECT_EQ(page.find("<title>motor 1 drive"), std::string::npos);
    expect_all(page, {"2400"});
    EXPECT_LT(occurrences(page, "<circle class=\"dot"), 2500u);
}

TEST(IdentificationText, EndsWithTheProfilesLines) {
    const std::string text = identification_text(identified({"agonist"}));
    EXPECT_NE(text.find("\nbackdrive "), std::string::npos);
    EXPECT_NE(text.find("[rig]\ngear_friction = 0.2"), std::string::npos);
    EXPECT_EQ(text.find("constant_Nm ="), std::string::npos);
}

}  // namespace
}  // namespace fusee::report
