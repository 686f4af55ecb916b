#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "codesign/problem.h"
#include "fusee/actuator/dead_band.h"
#include "fusee/core/csv.h"
#include "fusee/core/units.h"
#include "fusee/design/robust.h"
#include "fusee/pipeline/design.h"
#include "fusee/pipeline/evaluate.h"
#include "fusee/search/design.h"
#include "pipeline/fixture.h"
#include "written.h"

namespace fusee::search::codesign {
namespace {

namespace fs = std::filesystem;

class CoDesignRun : public fixtures::TempFolder {
protected:
    /// The neighbourhood of the co-designed profile under weak demands, so that few generations find what is feasible; coarse solids, since
    /// every design found is made.
    [[nodiscard]] profile::Profile read(const std::map<std::string, std::string>& keys = {}) const {
        std::string text = core::read_file(fixtures::shipped("pnrvsa_co_design"));
        for (const auto& [key, value] : std::map<std::string, std::string>{{"name", "\"small\""},
                                                                           {"design.population", "16"},
                                                                           {"design.generations", "16"},
                                                                           {"outputs.formats", "[\"stl\"]"},
                                                                           {"tolerances.chordal_error_mm", "0.005"},
                                                                           {"co_design.travel_rad", "1.0"},
                                                                           {"co_design.stiff_Nm_per_rad", "0.5"},
                                                                           {"co_design.contour_radius_mm", "60.0"},
                                                                           {"co_design.least_rho_se_mm", "3.0"},
                                                                           {"co_design.span", "1.2"},
                                                                           {"co_design.lead_in_deg", "[0.0, 3.0]"},
                                                                           {"co_design.winding_rad", "[2.5, 4.0]"},
                                                                           {"co_design.compression_mm", "[2.0, 4.0]"},
                                                                           {"co_design.capstan_radius_mm", "[38.0, 40.0]"}})
            text = fixtures::with_key(text, key, value);
        for (const auto& [key, value] : keys) text = fixtures::with_key(text, key, value);
        return profile::read_profile(write("p/small.toml", text));
    }
    [[nodiscard]] RunOptions into(const std::string& out, unsigned jobs = 0) const {
        RunOptions options;
        options.out = folder_ / out;
        options.jobs = jobs;
        return options;
    }
    [[nodiscard]] static std::map<std::string, std::string> files_in(const fs::path& folder) {
        std::map<std::string, std::string> files;
        for (const auto& entry : fs::recursive_directory_iterator(folder))
            if (entry.is_regular_file()) files[entry.path().lexically_relative(folder).string()] = core::read_file(entry.path());
        return files;
    }
};

TEST_F(CoDesignRun, FindsADesignThatMakeAcceptsAndSaysWhatLimitsIt) {
    const Written result = written(run_co_design, read(), into("out"));
    ASSERT_TRUE(result.found());
    const auto files = files_in(result.folder);
    ASSERT_TRUE(files.contains("small-best.toml") && files.contains("design.json") && files.contains("design.html"));
    const profile::Profile best = profile::read_profile(result.folder / "small-best.toml");
    const pipeline::Evaluation made = pipeline::evaluate(best, pipeline::Depth::kFiles);
    EXPECT_TRUE(made.passed());

    const double width = actuator::dead_band(pipeline::resolve(best)->actuator, 1.0).exact_width;
    const auto json = nlohmann::json::parse(files.at("design.json"));
    EXPECT_EQ(json["method"], "co_design");
    EXPECT_NEAR(json["figures"][0]["found"].get<double>(), core::deg_from_rad(width), 1e-6);
    EXPECT_NE(result.summary[2].find("limited by"), std::string::npos);
}

TEST_F(CoDesignRun, SameBytesOnAnyNumberOfThreadsAndWhenResumed) {
    const profile::Profile profile = read();
    ASSERT_TRUE(written(run_co_design, profile, into("one", 1)).found());
    ASSERT_TRUE(written(run_co_design, profile, into("three", 3)).found());
    EXPECT_EQ(files_in(folder_ / "one/small-design"), files_in(folder_ / "three/small-design"));

    RunOptions stopped = into("parts");
    int looks = 0;
    stopped.stop = [&looks] { return ++looks > 4; };
    EXPECT_TRUE(run_co_design(profile, stopped).interrupted);
    RunOptions resumed = into("parts");
    resumed.resume = true;
    ASSERT_TRUE(written(run_co_design, profile, resumed).found());
    EXPECT_EQ(files_in(folder_ / "one/small-design"), files_in(folder_ / "parts/small-design"));
}

TEST_F(CoDesignRun, MinimisedOverAShopsScatterItsCostIsWhatBuiltJointsHaveAndTheirSpringsReach) {
    const auto robust = [](const profile::Profile& best, double torque) {
        const design::DrawnJoint drawing{pipeline::resolve(best)->actuator, best.k_se.spring, best.k_pe.spring};
        return design::robust_dead_band(drawing, torque, {.rate_se = 0.05, .rate_pe = 0.05, .contour = 0.05e-3, .friction = 0.05});
    };
    const Written built = written(run_co_design,
                                  read({{"design.generations", "30"},
                                        {"co_design.figure", "\"percentile_95\""},
                                        {"co_design.scatter_friction", "0.05"},
                                        {"co_design.reviews", "\"accept\""}}),
                                  into("built"));
    const Written drawn = written(run_co_design, read({{"co_design.reviews", "\"accept\""}}), into("drawn"));
    ASSERT_TRUE(built.found() && drawn.found());
    const profile::Profile best = profile::read_profile(built.folder / "small-best.toml");
    const auto json = nlohmann::json::parse(core::read_file(built.folder / "design.json"));
    const double mean = 0.5 * (robust(best, 1.0).band.high + robust(best, 1.5).band.high);
    EXPECT_NEAR(json["cost"].get<double>(), core::deg_from_rad(mean), 1e-9);
    EXPECT_GE(robust(best, 1.5).covered_share, 0.95);
    const profile::Profile other = profile::read_profile(drawn.folder / "small-best.toml");
    EXPECT_LT(robust(other, 1.5).covered_share, 0.9) << "its law ends where the drawn edge does";
}

TEST_F(CoDesignRun, WhatCannotBeNamesTheLimitsAndWritesNothing) {
    const Written result = written(run_co_design, read({{"design.generations", "3"}, {"co_design.contour_radius_mm", "5.0"}}), into("out"));
    EXPECT_FALSE(result.found());
    EXPECT_FALSE(fs::exists(folder_ / "out/small-design"));
    ASSERT_FALSE(result.findings.empty());
    EXPECT_TRUE(std::any_of(result.findings.begin(), result.findings.end(),
                            [](const core::Finding& f) { return f.rule == "limit.contour_radius"; }));
    for (const core::Finding& f : result.findings) EXPECT_EQ(f.severity, core::Severity::kError);
}

TEST_F(CoDesignRun, EachPointOfAFrontIsAProfileThatMakeAccepts) {
    const Written result = written(run_pareto, read({{"design.population", "8"}, {"design.generations", "24"}}), into("out"));
    ASSERT_TRUE(result.found());
    const auto files = files_in(result.folder);
    ASSERT_TRUE(files.contains("pareto.json") && files.contains("pareto.csv") && files.contains("pareto.html") &&
                files.contains("pareto/01.toml"));
    const profile::Profile first = profile::read_profile(result.folder / "pareto/01.toml");
    EXPECT_TRUE(pipeline::evaluate(first, pipeline::Depth::kFiles).passed());
    // as many rows as profiles; a wider dead-band buys more travel
    const core::CsvTable table = core::read_csv(result.folder / "pareto.csv", {{"figure_deg"}, {"travel_rad"}});
    EXPECT_EQ(table.rows() + 4, files.size());  // and the JSON, the CSV, the page and the manifest
    for (std::size_t i = 1; i < table.rows(); ++i) {
        EXPECT_GE(table.numbers("figure_deg")[i], table.numbers("figure_deg")[i - 1]);
        EXPECT_GE(table.numbers("travel_rad")[i], table.numbers("travel_rad")[i - 1]);
    }
}

TEST_F(CoDesignRun, AFrontAgainstSizeTradesOneForTheOther) {
    const Written result = written(run_pareto, read({{"design.population", "24"}, {"co_design.against", "\"size\""}}), into("out"));
    ASSERT_TRUE(result.found());
    const core::CsvTable table = core::read_csv(result.folder / "pareto.csv", {{"figure_deg"}, {"radius_mm"}});
    for (std::size_t i = 1; i < table.rows(); ++i) {
        EXPECT_GE(table.numbers("figure_deg")[i], table.numbers("figure_deg")[i - 1]);
        EXPECT_LE(table.numbers("radius_mm")[i], table.numbers("radius_mm")[i - 1]);
    }
}

TEST(SearchChanges, ReplaceOnlyWhatTheyName) {
    design::SearchOptions search{.method = design::Method::kPareto, .population = 20, .generations = 30, .seed = 4};
    change_search(search, {.generations = 5});
    EXPECT_EQ(search.method, design::Method::kPareto);
    EXPECT_EQ(search.population, 20);
    EXPECT_EQ(search.generations, 5);
    EXPECT_EQ(search.seed, 4);
    for (const auto& [name, method] : std::map<std::string, design::Method>{
             {"algorithm_1", design::Method::kAlgorithm1}, {"co_design", design::Method::kCoDesign}, {"pareto", design::Method::kPareto}}) {
        change_search(search, {.method = name});
        EXPECT_EQ(search.method, method) << name;
    }
    EXPECT_THROW(change_search(search, {.method = "luck"}), core::InvalidInput);
}

}  // namespace
}  // namespace fusee::search::codesign
