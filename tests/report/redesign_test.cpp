#include <cmath>
#include <nlohmann/json.hpp>

#include "fusee/report/search.h"
#include "page_structure.h"

namespace fusee::report {
namespace {

Redesign one_profile() {
    Redesign r;
    r.profile_name = "arm";
    r.new_cams_needed = true;
    r.profiles.push_back(
        {"agonist", "dir/arm <new>.toml", "name = 1", {{{"rig.gear_friction", "0.364", "0.28"}, "gear.load_friction <b>"}}, {}, {}});
    r.levels = {{0.8, {0.5, 0.40}, {0.7, 0.50}, {0.5, 0.42}}, {1.0, {0.4, 0.30}, {0.6, 0.33}, {0.4, 0.30}}, {1.2, {}, {}, {}}};
    r.peak = {1.0, {0.4, 0.30}, {0.6, 0.33}, {0.5, 0.31}};
    r.profiles[0].cover = {{0.85, 1.5}, {0.9, 1.31}, {0.56, 2.08}, {0.6, 2.36}};
    r.torque_error_old = 0.106;
    r.torque_error_new = 1e-5;
    r.not_mended = {{{"joint.coulomb", "none"}, "look at the bearing"}};
    r.remarks = {"Only the agonist's cams < are new."};
    return r;
}

// Known: (25 % + 10 %)/2 and (5 % + 0 %)/2; the level that is not known does not count.
TEST(Redesign, MeansOverTheKnownLevels) {
    EXPECT_NEAR(one_profile().off_with_old_cams(), 0.175, 1e-12);
    EXPECT_NEAR(one_profile().off_with_new_cams(), 0.025, 1e-12);
    EXPECT_TRUE(std::isnan(Redesign{}.off_with_new_cams()));
}

TEST(Redesign, JsonHoldsEveryFigure) {
    const auto j = nlohmann::json::parse(redesign_json(one_profile()));
    EXPECT_EQ(j["profiles"][0]["changes"][0]["is"], "0.364");
    EXPECT_EQ(j["profiles"][0]["can_be_cut"], true);
    EXPECT_EQ(j["dead_band"][1]["old_cams"]["measured_rad"], 0.33);
    EXPECT_TRUE(j["dead_band"][2]["promised"]["measured_rad"].is_null());
    EXPECT_EQ(j["not_mended"][0]["id"], "joint.coulomb");
    EXPECT_EQ(j["at_peak"]["new_cams"]["exact_rad"], 0.5);
    EXPECT_EQ(j["at_peak"]["new_cams"]["extreme_rad"], 0.5) << "old spelling";
    EXPECT_EQ(j["profiles"][0]["asked_Nm"], (nlohmann::json{0.85, 1.5}));
    EXPECT_EQ(j["profiles"][0]["covered_Nm"], (nlohmann::json{0.9, 1.31}));
    EXPECT_EQ(j["profiles"][0]["coverage"], coverage(one_profile().profiles[0].cover));
    EXPECT_TRUE(nlohmann::json::parse(redesign_json(Redesign{}))["at_peak"].is_null());
}

TEST(Redesign, TextStatesTheFigures) {
    expect_all(
        redesign_text(one_profile()),
        {"11 %", "18 % with the old cams, 2.5 % with new cams", "1 Nm: exact dead-band as in fusee make 22.9 deg", "28.6 with new cams",
         "test 17.2 deg", "3 levels", "0.9 to 1.31 Nm of the 0.85 to 1.5 Nm in use", "0.6 to 2.36 Nm", "joint.coulomb"});
}

TEST(Redesign, StatesTheCoverageAndWhatRefusesTheCams) {
    Redesign r = one_profile();
    r.profiles[0].cover.covered = r.profiles[0].cover.asked;
    expect_all(redesign_text(r), {"covers all co-contractions in use, 0.85 to 1.5 Nm"});
    r.profiles[0].cover.covered = {diagnosis::kNoFigure, diagnosis::kNoFigure};
    expect_all(redesign_text(r), {"covers none of the co-contractions in use, 0.85 to 1.5 Nm"});
    r.profiles[0].findings = {core::error_finding("cam.arm", "an arm", 1.0, core::Bound::kAtLeast, 2.0, "mm")};
    expect_all(redesign_text(r), {"cam.arm"});
    EXPECT_EQ(nlohmann::json::parse(redesign_json(r))["profiles"][0]["can_be_cut"], false);
}

}  // namespace
}  // namespace fusee::report
