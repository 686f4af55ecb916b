#include "fusee/report/search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "fusee/spring/stiction_law.h"

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
    finding.suggestion = "law.end_torque_Nm = 1.8";
    report.cams = {{cam::PartKind::kSeries, {{1.0, 0.0, 0.02}, {1.1, 0.1, 0.021}}, std::nullopt, {finding}}};
    report.remarks = {"u & C stand at their edges"};
    return report;
}

TEST(Search, JsonHoldsEverythingAndNanIsNull) {
    const auto json = nlohmann::json::parse(search_json(small_report()));
    EXPECT_EQ(json["name"], "arm<1>-design");
    EXPECT_EQ(json["seed"], 5);
    EXPECT_EQ(json["variables"][0]["box"], (std::vector<double>{0.1, 0.3}));
    EXPECT_TRUE(json["variables"][0]["own"].is_null());
    EXPECT_EQ(json["figures"][0]["own"], 61.0);
    EXPECT_TRUE(json["dead_band"][0]["extreme_rad"].is_null());
    EXPECT_EQ(json["cams"][0]["part"], "k_se");
    EXPECT_EQ(json["cams"][0]["can_be_cut"], false);
    EXPECT_EQ(json["cams"][0]["findings"][0]["rule"], "cam.convexity");
    EXPECT_EQ(json["remarks"][0], "u & C stand at their edges");
}

TEST(Search, CsvsCarryEveryDigit) {
    const SearchReport report = small_report();
    EXPECT_EQ(history_csv(report.history), "generation,best_cost\n0,3\n1,0.33333333333333331\n2,-1.25\n");
    EXPECT_EQ(
        figure_9_csv(report.costs),
        "variable,value,cost,feasible\nu,-0.10000000000000001,1000000000,0\nu,0,-1.25,1\nu,0.10000000000000001,0.66666666666666663,1\n");
}

TEST(Search, PageIsEscapedAndSaysWhatBinds) {
    const std::string html = search_html(small_report());
    for (const char* word :
         {"arm&lt;1&gt;-design", "not for these base springs", "cam.convexity", "no &lt;convex&gt; contour", "law.end_torque_Nm = 1.8",
          "u &amp; C stand", "Cost over u", "Best cost of each generation", "Both springs over the capstan", "Lever arm of k_se", "24"})
        EXPECT_NE(html.find(word), std::string::npos) << word;
    for (const char* word : {"<1>", "<convex>", "<script", "http://", "https://", "nan", "inf"})
        EXPECT_EQ(html.find(word), std::string::npos) << word;
}

TEST(Search, WithoutCamsThePageSaysSo) {
    SearchReport report = small_report();
    report.cams.clear();
    EXPECT_NE(search_html(report).find("Springs found"), std::string::npos);
    EXPECT_NE(search_html(report).find("Not judged"), std::string::npos);
}

}  // namespace
}  // namespace fusee::report
