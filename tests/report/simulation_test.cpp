#include "fusee/report/simulation.h"

#include <nlohmann/json.hpp>

#include "fusee/core/units.h"
#include "page_structure.h"

namespace fusee::report {
namespace {

/// Two levels: at 1 Nm the exact extremes are not covered.
Simulation two_levels(const std::string& name = "joint") {
    Simulation s;
    s.provenance = {name, std::string(64, 'a'), "levels=2"};
    s.survey = unknown_survey();
    s.condition = {.torques = {0.5, 1.0}, .holds = {{0.5, 1.0}}, .values = {-0.2, -0.1}};
    for (const double tau : {0.5, 1.0}) {
        SimulatedLevel level = unknown_level(tau);
        level.dead_band.linear = 0.1 / tau;
        level.dead_band.exact_width = tau < 1.0 ? 0.22 : kUnknown;
        level.dead_band.measured_width = 0.11 / tau;
        level.dead_band.condition_6 = -0.1;
        level.reading.push_torque = 0.3;
        level.reading.full_push = tau < 1.0 ? 0.25 : 0.4;
        level.reading.covered_push = 0.3;
        s.levels.push_back(level);
    }
    MeasuredRow row{0.5, core::rad_from_deg(12.0), s.levels[0].dead_band};
    s.measured = {row};
    s.path = ReleasePath{1.0, {0.8, 1.4}, {{0.0, 0.0, 1.0, 1.0}, {0.3, 0.2, 1.2, 0.8}}, {{0.0, 0.1, 1.0, 1.0}}};
    s.break_away = {{0.0, {0.0, 0.0}}, {1.0, {0.8, 1.4}}};
    return s;
}

TEST(SimulationCsv, HasExactlyItsColumnsAndEveryBit) {
    const std::string csv = dead_band_csv(two_levels().levels);
    EXPECT_EQ(csv,
              "tau_Nm,linear_rad,extreme_rad,protocol_rad,condition_6,joint_stiffness_Nm_per_rad,capstan_rad\n"
              "0.5,0.20000000000000001,0.22,0.22,-0.10000000000000001,nan,nan\n"
              "1,0.10000000000000001,nan,0.11,-0.10000000000000001,nan,nan\n");
}

TEST(SimulationJson, HoldsWhatItDocuments) {
    const auto j = nlohmann::json::parse(simulation_json(two_levels()));
    for (const char* key : {"fusee", "name", "profile_sha256", "options", "survey", "condition_6", "levels", "measured", "equilibria",
                            "path_columns", "path", "loops", "break_away", "bearing", "findings", "remarks", "not_known"})
        EXPECT_TRUE(j.contains(key)) << key;
    EXPECT_EQ(j["condition_6"]["verdict"], "holds");
    EXPECT_EQ(j["levels"][0]["exact_rad"], 0.22);
    EXPECT_TRUE(j["levels"][1]["exact_rad"].is_null());
    EXPECT_EQ(j["levels"][0]["full_push_Nm"], 0.25);
    EXPECT_EQ(j["path"]["up"][1], (std::vector<double>{0.3, 0.2, 1.2, 0.8}));
    EXPECT_EQ(j["break_away"][1]["loads_Nm"], (std::vector<double>{0.8, 1.4}));
}

TEST(SimulationJson, RenamedFieldsKeepTheirOldSpelling) {
    const auto j = nlohmann::json::parse(simulation_json(two_levels()));
    const auto& level = j["levels"][0];
    EXPECT_EQ(level["extreme_rad"], level["exact_rad"]);
    EXPECT_EQ(level["protocol_rad"], level["measured_rad"]);
    EXPECT_TRUE(level.contains("covered_protocol_rad") && level.contains("covered_measured_rad"));
    EXPECT_EQ(j["measured"][0]["measured_rad"].get<double>(), core::rad_from_deg(12.0));
    EXPECT_EQ(j["measured"][0]["protocol_rad"], 0.22) << "of the simulated test";
    EXPECT_EQ(j["measured"][0]["simulated_rad"], 0.22);
    EXPECT_EQ(j["renamed_fields"]["extreme_rad"], "exact_rad");
}

TEST(SimulationRemarks, StateWhereTheThreeDeadBandsDiverge) {
    std::string words;
    for (const std::string& remark : remarks(two_levels())) words += remark + "\n";
    expect_all(words, {"holds from 0.5 Nm to 1 Nm", "9.1 % less (11.5 instead of 12.6 deg at 0.5 Nm)", "at 1 Nm: at 1 Nm it is 0.3 Nm",
                       "0.4 Nm", "1 rows", "friction"});
    EXPECT_EQ(remarks(two_levels()).size(), 7u);
}

TEST(SimulationVerdict, FollowsTheSummary) {
    Simulation s = two_levels();
    EXPECT_EQ(condition_verdict(s.condition), ConditionVerdict::kHolds);
    s.condition = {.torques = {0.5, 1.0}, .holds = {}, .values = {0.1, 0.2}};
    EXPECT_EQ(condition_verdict(s.condition), ConditionVerdict::kFails);
    s.condition = {.torques = {0.5, 1.0}, .holds = {{0.7, 1.0}}, .values = {-0.1, 0.2}};
    EXPECT_EQ(condition_verdict(s.condition), ConditionVerdict::kMixed);
    s.condition.values = {kUnknown, kUnknown};
    EXPECT_EQ(condition_verdict(s.condition), ConditionVerdict::kNotKnown);
}

TEST(SimulationPage, HoldsTheJsonAndTheSummary) {
    Simulation s = two_levels("a<b");
    cam::WrapLoop loop;
    loop.rows = {{.tau = 0.5, .deflection_loading = 0.1, .deflection_unloading = 0.3}};
    s.wraps = {{cam::PartKind::kSeries, loop}};
    expect_shell(simulation_html(s), "simulation", simulation_json(s), simulation_text(s));
    const auto j = nlohmann::json::parse(simulation_json(s));
    EXPECT_EQ(j["wraps"][0]["rows"][0], (std::vector<double>{0.5, 0.1, 0.3}));
    EXPECT_EQ(j["made_by"], s.provenance.line());
}

TEST(SimulationEquilibria, StateWhereTheJointRestsOrWhyNot) {
    Simulation s = two_levels();
    EquilibriumRow rests{.torque = {1.0, 0.9, 0.0}}, refused{.torque = {5.0, 1.0, 0.0}}, pulled{.torque = {1.0, 1.0, 0.1}};
    for (EquilibriumRow* row : {&rests, &pulled}) {
        row->z = {0.5, 0.25, 1e-17};
        row->sensitivity.setConstant(2.0);
        row->cable_space.setConstant(0.003);
    }
    rests.dead_band.emplace();
    rests.dead_band->linear = core::rad_from_deg(10.0);
    rests.dead_band->exact_width = kUnknown;
    rests.dead_band->covered = false;
    refused.refusal = {core::error_finding("equilibrium.outside", "wound beyond", 1.9, core::Bound::kAtMost, 1.5, "rad")};
    s.equilibria = {rests, refused, pulled};
    const auto j = nlohmann::json::parse(simulation_json(s))["equilibria"];
    ASSERT_EQ(j.size(), 3u);
    EXPECT_EQ(j[0]["torques_Nm"], (std::vector<double>{1.0, 0.9, 0.0}));
    EXPECT_EQ(j[0]["z_rad"][0], 0.5);
    EXPECT_EQ(j[0]["cable_space_sensitivity_m_per_N"][2][1], 0.003);
    EXPECT_EQ(j[0]["hatted_sensitivity_m_per_N"], j[0]["cable_space_sensitivity_m_per_N"]);
    EXPECT_TRUE(j[0]["dead_band"]["exact_rad"].is_null());
    EXPECT_TRUE(j[1]["z_rad"][0].is_null());
    EXPECT_EQ(j[1]["findings"][0]["rule"], "equilibrium.outside");
    EXPECT_TRUE(j[2]["dead_band"].is_null());
    ASSERT_EQ(refusals(s).size(), 1u);
    expect_all(simulation_text(s),
               {"tau_1 = 1 Nm, tau_2 = 0.9 Nm, tau_q = 0 Nm", "theta_1 = 0.5 rad, theta_2 = 0.25 rad, q = 0 rad (0 deg)",
                "linear 10 deg; exact unknown", "equilibrium.outside"});
}

TEST(SimulationText, ComparesSeveral) {
    const std::string text = survey_text({two_levels("one"), two_levels("two")});
    EXPECT_NE(text.find("one"), std::string::npos);
    EXPECT_NE(text.find("two"), std::string::npos);
    EXPECT_EQ(text.find("nan"), std::string::npos);
    EXPECT_NE(relatives_csv({two_levels("one")}).find("\none,pnrvsa,nan,"), std::string::npos);
}

}  // namespace
}  // namespace fusee::report
