#include "fusee/report/search.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "fusee/spring/stiction_law.h"
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

TEST(Search, ThePageIsEscapedAndListsWhatBinds) {
    const std::string html = search_html(small_report());
    expect_page(html);
    expect_all(html, {"arm&lt;1&gt;-design", "verdict warning-tag", "cam.convexity", "no &lt;convex&gt; contour", "law.end_torque_Nm = 1.8",
                      "u &amp; C are", "Cost over u", "Lever arm of k_se", "<b>24</b>"});
    EXPECT_EQ(elements(html, "h2").size(), 5u) << "result, cost, springs, cams, findings";
}

TEST(Search, WithoutCamsThereIsNeitherDrawingNorFinding) {
    SearchReport report = small_report();
    report.cams.clear();
    const std::string html = search_html(report);
    EXPECT_TRUE(holds(html, "verdict pass-tag"));
    EXPECT_EQ(elements(html, "h2").size(), 4u);
    EXPECT_FALSE(holds(html, "class=\"cam"));
}

}  // namespace
}  // namespace fusee::report
