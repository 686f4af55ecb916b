#include "fusee/report/search.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "fusee/spring/laws.h"
#include "page_structure.h"

namespace fusee::report {
namespace {

SearchReport small_report() {
    const auto law = *spring::make_stiction_law({0.225, 0.0012, 0.265, 0.28, 0.6, 2.21});
    SearchReport report;
    report.provenance = {"arm<1>-design", std::string(64, 'a'), "method=algorithm_1"};
    report.method = "algorithm_1";
    report.population = 8, report.generations = 2, report.seed = 5, report.evaluations = 24, report.cost = -1.25;
    report.variables = {{"k", "1/(Nm rad)", {0.1, 0.3}, 0.225, NAN}};
    report.figures = {{"capstan travel", "deg", 60.0, 61.0}};
    report.history = {3.0, 1.0 / 3.0, -1.25};
    report.costs = {{"u", "Nm", {-0.1, 0.0, 0.1}, {1e9, -1.25, 2.0 / 3.0}, {false, true, true}, {-0.05, 0.05}, {NAN, -1.0}, 0.0}};
    report.found.samples = spring::sample_by_load(*law, 11);
    actuator::DeadBand level;
    level.tau = 1.0, level.linear = 0.9, level.exact_width = NAN;
    report.found.dead_band = {level, level};
    core::Finding finding = core::error_finding("cam.convexity", "no <convex> contour", -1.0, core::Bound::kAtLeast, 0.0, "mm");
    finding.suggestion = core::change("law.end_torque_Nm", "1.8");
    report.cams = {{cam::PartKind::kSeries, {{1.0, 0.0, 0.02}, {1.1, 0.1, 0.021}}, std::nullopt, {finding}}};
    report.remarks = {"u & C are at bounds"};
    return report;
}

TEST(Search, JsonHoldsEverythingAndNanIsNull) {
    const auto json = nlohmann::json::parse(search_json(small_report()));
    EXPECT_EQ(json["name"], "arm<1>-design");
    EXPECT_EQ(json["seed"], 5);
    EXPECT_EQ(json["variables"][0]["box"], (std::vector<double>{0.1, 0.3}));
    EXPECT_TRUE(json["variables"][0]["own"].is_null());
    EXPECT_EQ(json["figures"][0]["own"], 61.0);
    EXPECT_TRUE(json["dead_band"][0]["exact_rad"].is_null());
    EXPECT_TRUE(json["dead_band"][0].contains("extreme_rad")) << "old spelling";
    EXPECT_EQ(json["cams"][0]["part"], "k_se");
    EXPECT_EQ(json["cams"][0]["can_be_cut"], false);
    EXPECT_EQ(json["cams"][0]["findings"][0]["rule"], "cam.convexity");
    EXPECT_EQ(json["remarks"][0], "u & C are at bounds");
}

TEST(Search, CsvsCarryEveryDigit) {
    const SearchReport report = small_report();
    EXPECT_EQ(history_csv(report.history), "generation,best_cost\n0,3\n1,0.33333333333333331\n2,-1.25\n");
    EXPECT_EQ(
        figure_9_csv(report.costs),
        "variable,value,cost,feasible\nu,-0.10000000000000001,1000000000,0\nu,0,-1.25,1\nu,0.10000000000000001,0.66666666666666663,1\n");
}

TEST(Search, ThePageHoldsCurvesCostsAndWhatForbidsACam) {
    const SearchReport report = small_report();
    expect_shell(search_html(report, "found & written"), "search", search_json(report), "found & written");
    const auto json = nlohmann::json::parse(search_json(report));
    EXPECT_EQ(json["springs"]["theta_rad"].size(), 11u);
    EXPECT_TRUE(json["own_springs"]["theta_rad"].empty());
    EXPECT_EQ(json["costs"][0]["feasible"], (std::vector<bool>{false, true, true}));
    EXPECT_TRUE(json["costs"][0]["lowest_cost"][0].is_null());
    EXPECT_EQ(json["history"].size(), 3u);
    EXPECT_EQ(json["cams"][0]["arms"]["arm_m"][1], 0.021);
    EXPECT_TRUE(json["cams"][0]["drawing"].is_null());
    EXPECT_EQ(json["cams"][0]["findings"][0]["suggestion"], "law.end_torque_Nm = 1.8");
}

TEST(Search, AFrontIsOneRowADesign) {
    ParetoReport front;
    front.provenance = {"front", std::string(64, 'a'), ""};
    front.torques = {0.5, 1.0};
    front.points = {{"pareto/01.toml", 0.25, {0.25, NAN}, 1.5, {1.0, 2.0}, 0.02, 0.01, "radius"}};
    front.dropped_by = {"cam.convexity"};
    const auto json = nlohmann::json::parse(pareto_json(front));
    EXPECT_EQ(json["points"][0]["profile"], "pareto/01.toml");
    EXPECT_EQ(json["points"][0]["radius_mm"], 20.0);
    EXPECT_TRUE(json["points"][0]["dead_band_rad"][1].is_null());
    EXPECT_EQ(json["against"], "travel");
    expect_shell(pareto_html(front, "one design"), "pareto", pareto_json(front), "one design");
}

}  // namespace
}  // namespace fusee::report
