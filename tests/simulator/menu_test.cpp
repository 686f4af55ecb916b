#include "menu.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "fusee/diagnosis/diagnose.h"
#include "simulator/fixture.h"

// Two causes whose predictions of the given runs are one: the class, and the run that tells them apart.
namespace fusee::simulator {
namespace {

constexpr double kPreload_N = 30.0, kReach_m = 0.1;

/// F = k x + F_0 + W sin((x - c)/0.1): parameters in the order centre_m, rate_N_per_m, weight_N.
Columns lever(const Request& request) {
    const std::vector<double>& p = *request.parameters;
    Columns answer;
    for (const double x : request.inputs->at("x_m")) {
        if (std::abs(x) > 1.0) throw inference::Refusal("no such way");
        answer["force_N"].push_back(p[1] * x + kPreload_N + p[2] * std::sin((x - p[0]) / kReach_m));
    }
    return answer;
}

/// The lever with this weight, or a way that reads this share too little, moved by `reach` to both sides.
Case measured(double weight, double share, double reach) {
    gap_case::CaseTexts texts = fixtures::pulled_spring();
    texts["case.toml"] = R"([model]
[experiments.pull]
files = ["a.csv", "b.csv", "c.csv"]
inputs = ["t_s", "x_m"]
outputs = {force_N = 0.1}
[parameters]
rate_N_per_m = {nominal = 1000.0}
weight_N = {nominal = 0.0}
centre_m = {nominal = 0.0}
[effects.weight]
frees = ["weight_N", "centre_m"]
usual = [10.0, 0.1]
range = [-50.0, 50.0, -0.2, 0.2]
)";
    Case own = fixtures::read_case(texts);
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal(0.0, 0.1);
    const std::vector<double> figures{0.0, 1000.0, weight};
    for (std::size_t r = 0; r < 3; ++r) {
        Columns& columns = own.experiments[0].runs[r].columns;
        for (double& x : columns["x_m"]) x *= reach / 0.02;
        Columns at_work = columns;
        for (double& x : at_work["x_m"]) x *= 1.0 + share;
        columns["force_N"] = lever({&own.experiments[0], r, &figures, &at_work}).at("force_N");
        for (double& value : columns["force_N"]) value += normal(random);
    }
    return own;
}

diagnosis::Diagnosis diagnosis_of_links(const Case& own) {
    return diagnosis::diagnose_model(Simulated(own, lever), {own.name, own.sha256}, {.jobs = 1, .progress = {}});
}

// Within 20 mm the weight is a scale of the way. It frees one figure more, so that the evidence alone is 300 to 1 for the scale.
TEST(RunsAgain, CausesThatPredictTheRunsAlikeAreOneClass) {
    const diagnosis::Diagnosis found = diagnosis_of_links(measured(8.0, 0.0, 0.02));
    EXPECT_EQ(found.verdict, diagnosis::VerdictKind::kAmbiguous) << diagnosis_json(found);
    std::vector<std::string> ids{found.effects.at(0).cause.id};
    for (const diagnosis::Alternative& other : found.alternatives)
        if (!other.effects.empty()) ids.push_back(other.effects[0].id);
    EXPECT_NE(std::find(ids.begin(), ids.end(), "weight"), ids.end());
    EXPECT_NE(std::find(ids.begin(), ids.end(), "port.x_m.scale"), ids.end());
    ASSERT_FALSE(found.next.empty());
    EXPECT_EQ(found.next[0].variable, "x_m");
    EXPECT_NE(found.next[0].text.find(".csv again with x_m"), std::string::npos) << found.next[0].text;
}

TEST(RunsAgain, TheRunThatIsAskedForTellsThemApart) {
    const diagnosis::Diagnosis weight = diagnosis_of_links(measured(8.0, 0.0, 0.08));
    EXPECT_EQ(weight.verdict, diagnosis::VerdictKind::kIdentified) << diagnosis_json(weight);
    EXPECT_EQ(weight.effects.at(0).cause.id, "weight");
    const diagnosis::Diagnosis scale = diagnosis_of_links(measured(0.0, 0.08, 0.08));
    EXPECT_EQ(scale.verdict, diagnosis::VerdictKind::kIdentified) << diagnosis_json(scale);
    EXPECT_EQ(scale.effects.at(0).cause.id, "port.x_m.scale");
}

TEST(RunsAgain, HasEachInputAtOtherSizesAndPlaces) {
    const Case own = measured(0.0, 0.0, 0.02);
    const Simulated model(own, lever);
    const RunsAgain menu(model, own);
    ASSERT_EQ(menu.measurements().size(), 7U * 3U);  // two speeds, at 0, twice, higher, lower, four times; three runs
    EXPECT_EQ(menu.measurements()[0].what, "Run a.csv again at half the speed");
    EXPECT_EQ(menu.measurements()[6].what, "Run a.csv again with x_m at 0");
    EXPECT_EQ(menu.measurements()[20].what, "Run c.csv again with x_m 4 times as large");
    const std::vector<double> values = menu.predict({{}, {}});
    ASSERT_EQ(values.size(), menu.precisions(values).size());
    EXPECT_DOUBLE_EQ(menu.precisions(values)[0], 10.0);
    const double x = own.experiments[0].runs[0].columns.at("x_m")[3];
    EXPECT_DOUBLE_EQ(values[static_cast<std::size_t>(menu.measurements()[6].values[3])], kPreload_N);
    EXPECT_DOUBLE_EQ(values[static_cast<std::size_t>(menu.measurements()[18].values[3])], 4000.0 * x + kPreload_N);
}

TEST(RunsAgain, WhatTheSimulatorRefusesTellsNothing) {
    Case own = measured(8.0, 0.0, 0.02);
    for (simulator::Run& run : own.experiments[0].runs) run.columns["x_m"].back() = 0.3;  // four times as far is refused
    const Simulated model(own, lever);
    const RunsAgain menu(model, own);
    const std::vector<double> values = menu.predict({{}, {}});
    EXPECT_TRUE(std::isnan(values[static_cast<std::size_t>(menu.measurements()[18].values[0])]));
    EXPECT_TRUE(std::isfinite(values[static_cast<std::size_t>(menu.measurements()[0].values[0])]));
}

}  // namespace
}  // namespace fusee::simulator
