#include "fusee/simulator/case.h"

#include <gtest/gtest.h>

#include <random>
#include <regex>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/folder.h"
#include "simulator/fixture.h"

// The case.toml of a simulator: what it says, and what it may not say.
namespace fusee::simulator {
namespace {

using fixtures::pulled_spring;

std::string refusal_of(const std::string& from, const std::string& to) {
    gap_case::CaseTexts texts = pulled_spring();
    std::string& toml = texts["case.toml"];
    const std::size_t at = toml.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    toml.replace(at, from.size(), to);
    try {
        (void)fixtures::read_case(texts);
    } catch (const core::InputError& e) {
        return e.what();
    }
    return "";
}

void expect_refused(const std::string& from, const std::string& to, const std::vector<std::string>& words) {
    const std::string message = refusal_of(from, to);
    for (const std::string& word : words) EXPECT_NE(message.find(word), std::string::npos) << to << ": " << message;
}

TEST(SimulatorCase, HasRunsParametersAndEffects) {
    const Case own = fixtures::read_case(pulled_spring());
    EXPECT_EQ(own.name, "spring");
    EXPECT_EQ(own.command, (std::vector<std::string>{"python3", "spring.py"}));
    ASSERT_EQ(own.experiments.size(), 1U);
    ASSERT_EQ(own.experiments[0].runs.size(), 3U);
    EXPECT_EQ(own.experiments[0].runs[1].file, "b.csv");
    EXPECT_EQ(own.experiments[0].runs[1].rows(), 24U);
    EXPECT_EQ(own.experiments[0].time(), "t_s");
    EXPECT_EQ(own.experiments[0].outputs[0].unit, "N");
    ASSERT_EQ(own.parameters.size(), 2U);
    EXPECT_EQ(own.parameters[0].name, "friction_N");
    EXPECT_DOUBLE_EQ(own.parameters[1].sigma, 20.0);
    ASSERT_EQ(own.effects.size(), 1U);
    EXPECT_EQ(own.effects[0].frees, (std::vector<std::size_t>{0}));
    EXPECT_EQ(own.effects[0].remedy, "Oil it.");
}

TEST(SimulatorCase, ColumnsMayHaveOtherNamesUnitsAndSigns) {
    gap_case::CaseTexts texts = pulled_spring();
    texts["case.toml"] += "\n[columns.pull]\nx_m = {column = \"way\", unit = \"mm\", factor = -1}\nforce_N = \"pull in mN\"\n";
    for (const char* file : {"a.csv", "b.csv", "c.csv"}) texts[file].replace(0, texts[file].find('\n'), "t_s,way,pull");
    const Case plain = fixtures::read_case(pulled_spring()), mapped = fixtures::read_case(texts);
    EXPECT_NEAR(mapped.experiments[0].runs[0].columns.at("x_m")[3], -1e-3 * plain.experiments[0].runs[0].columns.at("x_m")[3], 1e-12);
    EXPECT_NEAR(mapped.experiments[0].runs[0].columns.at("force_N")[3], 1e-3 * plain.experiments[0].runs[0].columns.at("force_N")[3], 1e-9);
}

TEST(SimulatorCase, NoiseIsEstimatedFromThirdDifferences) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal(0.0, 0.01);
    std::vector<double> smooth;
    for (int i = 0; i < 4000; ++i) smooth.push_back(std::sin(0.05 * i) + normal(random));
    EXPECT_NEAR(estimated_noise({&smooth}), 0.01, 0.0005);  // 5 %: the median of 4000 differences that share rows
    const std::vector<double> steps{0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 3, 4, 4, 4, 5, 5, 5, 5, 6, 6};
    EXPECT_GE(estimated_noise({&steps}), 1.0 / std::sqrt(12.0));
    EXPECT_TRUE(std::isnan(estimated_noise({})));
    gap_case::CaseTexts texts = pulled_spring();
    std::string& toml = texts["case.toml"];
    toml.replace(toml.find("force_N = 0.1"), 13, "force_N = \"estimate\"");
    const Case own = fixtures::read_case(texts);
    EXPECT_GT(own.experiments[0].outputs[0].sigma, 0.01);
    ASSERT_EQ(own.remarks.size(), 1U);
    EXPECT_NE(own.remarks[0].find("estimated"), std::string::npos);
}

TEST(SimulatorCase, RefusesWhatIsWrongWithItsPlace) {
    expect_refused("usual = 1.0", "usual = -1.0", {"spring/case.toml:15", "effects.friction.usual", "above 0"});
    expect_refused("usual = 1.0", "usual = 11.0", {"effects.friction.usual", "11", "a distance from the nominal value", "at most 10"});
    expect_refused("range = [0.0, 10.0]", "range = [1.0, 10.0]", {"effects.friction.range", "with the nominal value, 0"});
    expect_refused("range = [0.0, 10.0]", "range = [10.0, 0.0]", {"effects.friction.range", "low, then high"});
    expect_refused("range = [0.0, 10.0]", "range = [0.0]", {"effects.friction.range", "array of 2 numbers"});
    expect_refused("\"friction_N\"]", "\"fricton_N\"]",
                   {"effects.friction.frees", "fricton_N", "friction_N, rate_N_per_m; did you mean friction_N"});
    expect_refused("tolerance = 0.02", "tolerance = 0.02, tolerance_abs = 3.0", {"parameters.rate_N_per_m.tolerance", "both"});
    expect_refused("nominal = 0.0}", "nominal = 0.0, tolerance = 0.1}", {"parameters.friction_N.tolerance", "tolerance_abs"});
    expect_refused("nominal = 0.0}", "tolerance_abs = 0.1}", {"parameters.friction_N.nominal", "missing"});
    expect_refused("{force_N = 0.1}", "{force_N = \"guess\"}", {"experiments.pull.outputs.force_N", "estimate"});
    expect_refused("{force_N = 0.1}", "{x_m = 0.1}", {"experiments.pull.inputs", "x_m"});
    expect_refused("{force_N = 0.1}", "{F_N = 0.1}", {"a.csv", "F_N"});
    expect_refused("\"c.csv\"", "\"d.csv\"", {"experiments.pull.files", "d.csv", "not found"});
    expect_refused("[effects.friction]", "[effect.friction]", {"case.toml:13", "effect: unknown table"});
    expect_refused("[effects.friction]", "[effects.rate_N_per_m]", {"effects.rate_N_per_m", "a name of its own"});
    expect_refused("friction_N = {nominal = 0.0}", "friction_N = 0.0", {"parameters.friction_N", "no table"});
    expect_refused("[parameters]", "timeout = 3\n[parameters]", {"experiments.pull.timeout", "unknown key"});
}

TEST(SimulatorCase, TheModelMayStandInAnotherFile) {
    const core::TemporaryFolder folder;
    gap_case::CaseTexts texts = pulled_spring();
    std::string& toml = texts["case.toml"];
    const std::size_t logs = toml.find("[experiments"), figures = toml.find("[parameters]");
    core::write_file(folder.path() / "other.toml",
                     std::regex_replace(toml.substr(0, logs) + toml.substr(figures), std::regex("1000"), "900"));
    const Case whole = read_case(gap_case::CaseFiles("spring", texts), false);
    const Case in_place = read_case(gap_case::CaseFiles("spring", texts), false, folder.path() / "other.toml");
    toml = toml.substr(logs, figures - logs);
    const Case alone = read_case(gap_case::CaseFiles("spring", texts), false, folder.path() / "other.toml");
    EXPECT_EQ(whole.model, "spring/case.toml");
    EXPECT_EQ(alone.model, folder.path() / "other.toml");
    EXPECT_EQ(alone.command, whole.command);
    EXPECT_DOUBLE_EQ(whole.parameters[1].nominal, 1000.0);
    for (const Case& own : {in_place, alone}) {
        EXPECT_DOUBLE_EQ(own.parameters[1].nominal, 900.0);
        EXPECT_EQ(own.effects.at(0).id, "friction");
        EXPECT_EQ(own.experiments.at(0).runs.size(), 3U);
    }
    EXPECT_NE(in_place.sha256, whole.sha256);
}

TEST(SimulatorCase, TimesIncrease) {
    gap_case::CaseTexts texts = pulled_spring();
    texts["b.csv"] = "t_s,x_m,force_N\n0,0,0\n0.1,0,0\n0.1,0,0\n0.2,0,0\n";
    EXPECT_THROW((void)fixtures::read_case(texts), core::InputError);
}

TEST(SimulatorCase, AFolderNeedsACommand) {
    gap_case::CaseTexts texts = pulled_spring();
    std::string& toml = texts["case.toml"];
    toml.erase(toml.find("command"), toml.find("\n\n") - toml.find("command"));
    EXPECT_NO_THROW((void)fixtures::read_case(texts));
    EXPECT_THROW((void)read_case(gap_case::CaseFiles("spring", texts), true), core::InvalidInput);
}

}  // namespace
}  // namespace fusee::simulator
