#include "fusee/report/paper.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "fusee/core/units.h"
#include "fusee/spring/laws.h"
#include "page_structure.h"

namespace fusee::report {
namespace {

PaperTable paper_table(const std::vector<double>& measured_deg) {
    PaperTable table;
    table.simulation.provenance = {"arm<1>", std::string(64, 'a'), ""};
    table.simulation.condition.values = {-0.2, -0.1};
    double tau = 0.5;
    for (const double width : measured_deg) {
        MeasuredRow row{tau, core::rad_from_deg(width), unknown_level(tau).dead_band};
        row.computed.linear = core::rad_from_deg(width + 10.0);
        row.computed.exact_width = tau > 0.5 ? core::rad_from_deg(width - 20.0) : kUnknown;
        table.simulation.measured.push_back(row);
        table.simulation.levels.push_back(unknown_level(tau));
        table.simulation.levels.back().dead_band = row.computed;
        table.parallel.push_back(0.125);
        tau += 0.5;
    }
    return table;
}

Paper small_paper() {
    Paper paper;
    paper.provenance = {"paper", std::string(64, 'b'), ""};
    paper.figure_1 = {{"noise & both", {}, {1.0, 2.0}, {0.5, 0.4}, {0.5, 0.25}, {-0.25, -0.125}, ""},
                      {"floating", {}, {}, {}, {}, {}, "error: noise.unbounded"}};
    paper.figure_2 = {{0.2, 0.3}, {0.08, 0.12}, {{0.0, 0.0, 0.0, 0.0}, {0.0, 1.0, 0.12, 0.125}}, {{0.0, 0.1}, {1.0, 0.3}}};
    paper.table_1 = paper_table({30.0, 60.0});
    paper.table_2 = paper_table({90.0, 50.0, 45.0});
    std::vector<gap_case::BreakAway> rows;
    double more = 0.02;
    for (const double motor : {0.2, 0.5, 0.9, 1.4})
        for (const bool backdrive : {true, true, false, false})
            rows.push_back({"a", backdrive, motor, motor / (1.0 - (backdrive ? 1.0 : -1.0) * 0.25 * (1.0 + (more = -more)))});
    paper.figure_8 = {"break_away", std::string(64, 'c'), gap_case::identify_friction(rows)};
    paper.figure_9.variables = {{"k", "1/(Nm rad)", {0.1, 0.3}, 0.225, NAN}};
    paper.figure_9.costs = {{"u", "Nm", {-0.1, 0.0, 0.1}, {3.0, -1.0, 3.0}, {true, true, true}, {}, {}, 0.0}};
    paper.figure_9.found.samples = spring::sample_by_load(**spring::make_stiction_law({0.225, 0.0012, 0.265, 0.28, 0.6, 2.21}), 11);
    paper.figure_9.cams = {{cam::PartKind::kSeries, {{1.0, 0.0, 0.02}, {1.1, 0.1, 0.021}}, std::nullopt, {}}};
    paper.relatives.resize(1);
    paper.relatives[0].survey.arrangement = actuator::Arrangement::kSeriesElastic;
    paper.torque_control = {paper.relatives[0].survey};
    paper.torque_control[0].dead_band = {INFINITY, INFINITY};
    return paper;
}

std::string line_of(const std::string& text, int number) {
    std::size_t at = 0;
    for (int i = 0; i < number; ++i) at = text.find('\n', at) + 1;
    return text.substr(at, text.find('\n', at) - at);
}

TEST(PaperCsv, NumbersComeBackBitForBit) {
    const Paper paper = small_paper();
    EXPECT_EQ(line_of(figure_1_csv(paper.figure_1), 0),
              "noise,c_Nm_per_rad,motor_variance_rad2,joint_variance_rad2,joint_slope_rad3_per_Nm");
    EXPECT_EQ(line_of(figure_1_csv(paper.figure_1), 2), "noise & both,2,0.40000000000000002,0.25,-0.125");
    EXPECT_EQ(line_of(figure_1_csv(paper.figure_1), 3), "");  // no bound, no rows
    EXPECT_EQ(line_of(figure_2_csv(paper.figure_2), 2), "0,1,0.12,0.125");
    EXPECT_EQ(line_of(figure_2_passive_csv(paper.figure_2), 2), "1,0.29999999999999999");
    EXPECT_EQ(line_of(figure_9_springs_csv(paper.figure_9.found), 1).substr(0, 22), "0.59999999999999998,0,");
    EXPECT_EQ(line_of(figure_9_arms_csv(paper.figure_9.cams), 0), "part,cam_angle_rad,arm_m");
    EXPECT_EQ(line_of(figure_8_csv(paper.figure_8), 0), "side,direction,motor_torque_Nm,rows,mean_load_Nm,mean_friction_Nm,deviation_Nm");
}

TEST(PaperCsv, ATableHoldsTheDifferenceOfEachRow) {
    const std::string csv = table_csv(small_paper().table_1);
    std::vector<double> cells;
    std::string row = line_of(csv, 2) + ",";
    for (std::size_t at = 0; at < row.size(); at = row.find(',', at) + 1) cells.push_back(std::stod(row.substr(at)));
    ASSERT_EQ(cells.size(), 9u);
    const double expected[] = {1.0, 60.0, 70.0, 40.0, NAN, 10.0, -20.0, NAN, 0.125};
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (std::isnan(expected[i]))
            EXPECT_TRUE(std::isnan(cells[i])) << i;
        else
            EXPECT_NEAR(cells[i], expected[i], 1e-12) << i;  // degrees and back
    }
}

TEST(PaperCsv, APathHasBothPushes) {
    const ReleasePath path{1.0, {0.8, 1.4}, {{0.0, 0.0, 1.0, 1.0}, {0.5, 0.1, 1.2, 0.8}}, {{-0.5, -0.1, 0.8, 1.2}}};
    EXPECT_EQ(figure_6_csv(path),
              "push,joint_torque_Nm,q_rad,load_1_Nm,load_2_Nm\nup,0,0,1,1\nup,0.5,0.10000000000000001,1.2,0.80000000000000004\n"
              "down,-0.5,-0.10000000000000001,0.80000000000000004,1.2\n");
}

TEST(PaperFigures, SummariseTheirRows) {
    Paper paper = small_paper();
    EXPECT_TRUE(paper.figure_1[0].monotone());
    paper.figure_1[0].slope[1] = 1e-6;
    EXPECT_FALSE(paper.figure_1[0].monotone());
    EXPECT_NEAR(paper.figure_2.largest_difference(), 0.005, 1e-15);  // rounding of 0.125 - 0.12
    EXPECT_TRUE(paper.table_1.rises());
    EXPECT_FALSE(paper.table_2.rises());
}

TEST(PaperClaims, StateThePapersWordsAndTheFiguresFound) {
    Paper paper = small_paper();
    const std::string text = paper_text(paper);
    expect_all(text, {"noise & both;", "no bound for floating", "mu = 0.2", "between u and -u: 0\n",
                      "rises from 30 deg at 0.5 Nm to 60 deg at 1 Nm", "falls from 90 deg at 0.5 Nm to 45 deg at 1.5 Nm",
                      "exact 40 deg at 1 Nm to 40 deg at 1 Nm"});
    EXPECT_EQ(occurrences(text, "\n"), 2 * claims(paper).size());
    paper.figure_9.costs[0].cost[0] = 6.0;
    expect_all(paper_text(paper), {"between u and -u: 1\n"});
}

TEST(PaperJson, NanAndInfinityAreNull) {
    const auto json = nlohmann::json::parse(paper_json(small_paper()));
    EXPECT_TRUE(json["figure_6"].is_null());
    EXPECT_EQ(json["figure_1"][1]["refusal"], "error: noise.unbounded");
    EXPECT_TRUE(json["table_1"]["rows"][0]["exact_rad"].is_null());
    EXPECT_EQ(json["table_1"]["rows"][1]["extreme_rad"], json["table_1"]["rows"][1]["exact_rad"]) << "old spelling";
    EXPECT_EQ(json["table_2"]["rows"].size(), 3u);
    EXPECT_TRUE(json["relatives"][0]["torque_control"]["dead_band_rad"][0].is_null());
    EXPECT_EQ(json["claims"][0]["piece"], "figure 1");
}

TEST(PaperHtml, HoldsEveryFigureOfThePaper) {
    const Paper paper = small_paper();
    expect_shell(paper_html(paper), "paper", paper_json(paper), paper_text(paper));
    const auto json = nlohmann::json::parse(paper_json(paper));
    EXPECT_EQ(json["figure_2"]["rows"][1]["parallel_Nm"], 0.125);
    EXPECT_EQ(json["figure_2"]["passive"]["force_Nm"][1], 0.3);
    EXPECT_EQ(json["figure_8"]["identification"]["name"], "break_away");
    EXPECT_EQ(json["figure_9"]["costs"][0]["variable"], "u");
    EXPECT_EQ(json["table_1"]["simulation"]["name"], "arm<1>");
    EXPECT_EQ(json["table_1"]["simulation"]["measured"][0]["measured_rad"], json["table_1"]["rows"][0]["paper_rad"]);
}

}  // namespace
}  // namespace fusee::report
