#include "fusee/report/identification.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace fusee::report {
namespace {

/// Friction 0.25 times the load, 2 % more or less in turn; two repeats.
Identification identification(const std::vector<std::string>& sides) {
    std::vector<identification::BreakAway> rows;
    double more = 0.02;
    for (const std::string& side : sides)
        for (const double motor : {0.2, 0.5, 0.9, 1.4})
            for (const bool backdrive : {true, true, false, false})
                rows.push_back({side, backdrive, motor, motor / (1.0 - (backdrive ? 1.0 : -1.0) * 0.25 * (1.0 + (more = -more)))});
    return {"bench", "0123456789abcdef", identification::identify_friction(rows)};
}

std::size_t count(const std::string& text, const std::string& what) {
    std::size_t n = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
    return n;
}

TEST(IdentificationJson, HoldsWhatWasFound) {
    const Identification found = identification({"agonist", "antagonist"});
    const auto j = nlohmann::json::parse(identification_json(found));
    EXPECT_EQ(j["name"], "bench");
    EXPECT_EQ(j["lines"].size(), 9u);
    EXPECT_EQ(j["lines"][0]["mu"].get<double>(), found.friction.lines[0].mu);
    EXPECT_EQ(j["lines"][0]["mu_95"][1].get<double>(), found.friction.lines[0].mu_95.high);
    EXPECT_EQ(j["law"]["gear_friction"].get<double>(), found.friction.law->mu);
    EXPECT_EQ(j["repeats"].size(), 16u);
    EXPECT_EQ(j["remarks"][0]["id"], "constant");
}

TEST(IdentificationHtml, ShowsFigure8AndEscapesNames) {
    const std::string page = identification_html(identification({"<b>", "other"}));
    EXPECT_EQ(count(page, "<circle class=\"dot"), 2 * (16u + 4u));  // two pictures: a dot for each repeat, four keys
    EXPECT_EQ(count(page, "class=\"band"), 1u);
    EXPECT_NE(page.find("gear_friction = 0.2"), std::string::npos);
    EXPECT_EQ(page.find("<b> drive"), std::string::npos);
    for (const char* never : {"nan", "inf\"", "http", "<script"}) EXPECT_EQ(page.find(never), std::string::npos) << never;
}

TEST(IdentificationHtml, ManyMotorsShareTwoColours) {
    std::vector<std::string> sides;
    for (int i = 0; i < 300; ++i) sides.push_back("motor " + std::to_string(i));
    const std::string page = identification_html(identification(sides));
    EXPECT_EQ(page.find("<title>motor 1 drive"), std::string::npos);
    EXPECT_NE(page.find("Of 2400 only one in 2 is drawn"), std::string::npos);
    EXPECT_LT(count(page, "<circle class=\"dot"), 2500u);
}

TEST(IdentificationText, EndsWithTheProfilesLines) {
    const std::string text = identification_text(identification({"agonist"}));
    EXPECT_NE(text.find("\nbackdrive "), std::string::npos);
    EXPECT_NE(text.find("[rig]\ngear_friction = 0.2"), std::string::npos);
    EXPECT_EQ(text.find("constant_Nm ="), std::string::npos);
}

}  // namespace
}  // namespace fusee::report
