#include "fusee/report/redesign.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace fusee::report {
namespace {

Redesign some() {
    Redesign r;
    r.profile_name = "arm";
    r.new_cams_needed = true;
    r.profiles.push_back(
        {"agonist", "dir/arm <new>.toml", "name = 1", {{"rig.gear_friction", "0.28", "0.364", "gear.load_friction <b>"}}, {}, {}});
    r.levels = {{0.8, {0.5, 0.40}, {0.7, 0.50}, {0.5, 0.42}}, {1.0, {0.4, 0.30}, {0.6, 0.33}, {0.4, 0.30}}, {1.2, {}, {}, {}}};
    r.peak = {1.0, {0.4, 0.30}, {0.6, 0.33}, {0.5, 0.31}};
    r.profiles[0].cover = {{0.85, 1.5}, {0.9, 1.31}, {0.56, 2.08}, {0.6, 2.36}};
    r.torque_error_old = 0.106;
    r.torque_error_new = 1e-5;
    r.not_mended = {{{"joint.coulomb", "none"}, "look at the bearing"}};
    r.remarks = {"Only the agonist's cams < are cut anew."};
    return r;
}

// Known: (25 % + 10 %)/2 and (5 % + 0 %)/2; the level that is not known does not count.
TEST(Redesign, MeansOverTheKnownLevels) {
    EXPECT_NEAR(some().off_with_old_cams(), 0.175, 1e-12);
    EXPECT_NEAR(some().off_with_new_cams(), 0.025, 1e-12);
    EXPECT_TRUE(std::isnan(Redesign{}.off_with_new_cams()));
}

TEST(Redesign, JsonHoldsEveryFigure) {
    const auto j = nlohmann::json::parse(redesign_json(some()));
    EXPECT_EQ(j["profiles"][0]["changes"][0]["is"], "0.364");
    EXPECT_EQ(j["profiles"][0]["can_be_cut"], true);
    EXPECT_EQ(j["dead_band"][1]["old_cams"]["read_rad"], 0.33);
    EXPECT_TRUE(j["dead_band"][2]["promised"]["read_rad"].is_null());
    EXPECT_EQ(j["not_mended"][0]["id"], "joint.coulomb");
    EXPECT_EQ(j["at_peak"]["new_cams"]["extreme_rad"], 0.5);
    EXPECT_EQ(j["profiles"][0]["asked_Nm"], (nlohmann::json{0.85, 1.5}));
    EXPECT_EQ(j["profiles"][0]["covered_Nm"], (nlohmann::json{0.9, 1.31}));
    EXPECT_TRUE(nlohmann::json::parse(redesign_json(Redesign{}))["at_peak"].is_null());
}

TEST(Redesign, SectionAndTextSayTheSame) {
    const std::string html = redesign_section(some()), text = redesign_text(some());
    for (const char* words : {"<svg", "arm &lt;new&gt;.toml", "gear.load_friction &lt;b&gt;", "cams &lt; are cut", "11 %", "18 %", "2.5 %"})
        EXPECT_NE(html.find(words), std::string::npos) << words;
    EXPECT_EQ(html.find("<b>"), std::string::npos);
    for (const char* words :
         {"18 % with the old cams, 2.5 % with new ones", "the agonist", "cut its cams by fusee make", "no cam mends joint.coulomb"})
        EXPECT_NE(text.find(words), std::string::npos) << text;
    for (const char* words :
         {"at peak torque, 1 Nm: exact dead-band, as fusee make gives it, 22.9 deg promised, 34.4 with the old cams, 28.6 with",
          "read by the push-and-release test 17.2 deg promised", "mean of 3 levels",
          "covers co-contractions of 0.9 to 1.31 Nm, asked for are 0.85 to 1.5 Nm: friction lets a capstan rest at loads from "
          "0.6 to 2.36 Nm, the springs' law has"}) {
        EXPECT_NE(text.find(words), std::string::npos) << text;
    }
    Redesign whole = some();
    whole.profiles[0].cover.covered = whole.profiles[0].cover.asked;
    EXPECT_NE(redesign_text(whole).find("covers all co-contractions asked for, 0.85 to 1.5 Nm"), std::string::npos);
    Redesign none = some();
    none.profiles[0].cover.covered = {diagnosis::kNoFigure, diagnosis::kNoFigure};
    EXPECT_NE(redesign_text(none).find("covers no co-contraction of the 0.85 to 1.5 Nm asked for"), std::string::npos);
    Redesign refused = some();
    refused.profiles[0].findings = {core::error_finding("cam.arm", "an arm", 1.0, core::Bound::kAtLeast, 2.0, "mm")};
    EXPECT_NE(redesign_text(refused).find("cam.arm"), std::string::npos);
    EXPECT_NE(redesign_section(refused).find("is going to refuse"), std::string::npos);
    EXPECT_EQ(redesign_section(Redesign{}), "");
}

}  // namespace
}  // namespace fusee::report
