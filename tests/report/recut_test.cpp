#include "fusee/report/recut.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace fusee::report {
namespace {

Recut some() {
    Recut r;
    r.profile_name = "arm";
    r.new_cams_needed = true;
    r.profiles.push_back(
        {"agonist", "dir/arm <new>.toml", "name = 1", {{"rig.gear_friction", "0.28", "0.364", "gear.load_friction <b>"}}, {}});
    r.levels = {{0.8, {0.5, 0.40}, {0.7, 0.50}, {0.5, 0.42}}, {1.0, {0.4, 0.30}, {0.6, 0.33}, {0.4, 0.30}}, {1.2, {}, {}, {}}};
    r.torque_error_old = 0.106;
    r.torque_error_new = 1e-5;
    r.not_mended = {{{"joint.coulomb", "none"}, "look at the bearing"}};
    r.remarks = {"Only the agonist's cams < are cut anew."};
    return r;
}

// Known: (25 % + 10 %)/2 and (5 % + 0 %)/2; the level that is not known does not count.
TEST(Recut, MeansOverTheKnownLevels) {
    EXPECT_NEAR(some().off_with_old_cams(), 0.175, 1e-12);
    EXPECT_NEAR(some().off_with_new_cams(), 0.025, 1e-12);
    EXPECT_TRUE(std::isnan(Recut{}.off_with_new_cams()));
}

TEST(Recut, JsonHoldsEveryFigure) {
    const auto j = nlohmann::json::parse(recut_json(some()));
    EXPECT_EQ(j["profiles"][0]["changes"][0]["is"], "0.364");
    EXPECT_EQ(j["profiles"][0]["can_be_cut"], true);
    EXPECT_EQ(j["dead_band"][1]["old_cams"]["read_rad"], 0.33);
    EXPECT_TRUE(j["dead_band"][2]["promised"]["read_rad"].is_null());
    EXPECT_EQ(j["not_mended"][0]["id"], "joint.coulomb");
}

TEST(Recut, SectionAndTextSayTheSame) {
    const std::string html = recut_section(some()), text = recut_text(some());
    for (const char* words : {"<svg", "arm &lt;new&gt;.toml", "gear.load_friction &lt;b&gt;", "cams &lt; are cut", "11 %", "18 %", "2.5 %"})
        EXPECT_NE(html.find(words), std::string::npos) << words;
    EXPECT_EQ(html.find("<b>"), std::string::npos);
    for (const char* words :
         {"18 % with the old cams, 2.5 % with new ones", "the agonist", "cut its cams by fusee make", "no cam mends joint.coulomb"})
        EXPECT_NE(text.find(words), std::string::npos) << text;
    Recut refused = some();
    refused.profiles[0].findings = {core::required_change("cam.arm", "an arm", 1.0, core::Bound::kAtLeast, 2.0, "mm")};
    EXPECT_NE(recut_text(refused).find("cam.arm"), std::string::npos);
    EXPECT_NE(recut_section(refused).find("is going to refuse"), std::string::npos);
    EXPECT_EQ(recut_section(Recut{}), "");
}

}  // namespace
}  // namespace fusee::report
