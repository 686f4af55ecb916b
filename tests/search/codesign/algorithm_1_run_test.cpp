#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "fusee/actuator/dead_band.h"
#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "fusee/pipeline/design.h"
#include "fusee/search/design.h"
#include "pipeline/fixture.h"
#include "written.h"

namespace fusee::search::codesign {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class Algorithm1Run : public fixtures::TempFolder {
protected:
    /// The shipped profile with keys set; a short search and coarse solids, since every test makes cams.
    [[nodiscard]] profile::Profile read(const std::map<std::string, std::string>& keys = {}) const {
        std::string text = core::read_file(fixtures::shipped("pnrvsa"));
        text = fixtures::with_key(text, "design.generations", "120");
        text = fixtures::with_key(text, "tolerances.chordal_error_mm", "0.02");
        for (const auto& [key, value] : keys) text = fixtures::with_key(text, key, value);
        return profile::read_profile(write("p/pnrvsa.toml", text));
    }
    [[nodiscard]] RunOptions into(const std::string& out) const {
        RunOptions options;
        options.out = folder_ / out;
        return options;
    }
    [[nodiscard]] static std::map<std::string, std::string> bytes_in(const fs::path& folder) {
        std::map<std::string, std::string> files;
        for (const auto& entry : fs::directory_iterator(folder))
            if (entry.path().filename() != core::kManifestName) files[entry.path().filename().string()] = core::read_file(entry.path());
        return files;
    }
    static void expect_refused(const profile::Profile& profile, const std::string& field) {
        try {
            (void)run_algorithm_1(profile, {});
            ADD_FAILURE() << field;
        } catch (const core::InvalidInput& e) {
            EXPECT_EQ(e.field(), field);
        }
    }
};

TEST_F(Algorithm1Run, WritesTheLawFoundAndHowItWasFound) {
    const profile::Profile profile = read();
    const Written result = written(run_algorithm_1, profile, into("out"));
    ASSERT_TRUE(result.found());
    EXPECT_FALSE(result.interrupted);
    EXPECT_EQ(result.folder, folder_ / "out" / "pnrvsa-design");
    const auto files = bytes_in(result.folder);
    std::vector<std::string> names;
    for (const auto& [name, text] : files) names.push_back(name);
    EXPECT_EQ(names, (std::vector<std::string>{"design.html", "design.json", "figure_9.csv", "history.csv", "pnrvsa-best.toml"}));

    const Json json = Json::parse(files.at("design.json"));
    EXPECT_EQ(json["method"], "algorithm_1");
    EXPECT_EQ(json["evaluations"], 121 * 60);
    EXPECT_EQ(json["generations"], 120);
    EXPECT_LT(json["cost"], 0.0);
    EXPECT_LT(json["cost"], json["figures"][0]["own"]) << "better than the profile's own law";
    // From 0.6 to 1 Nm the shipped law turns its capstan by just this much (docs/theory/springs.md, eq. 5).
    EXPECT_NEAR(json["figures"][1]["found"].get<double>(), json["figures"][1]["own"].get<double>(), 0.01);

    // The law found is a profile of the same joint, and what it says holds.
    const profile::Profile best = profile::read_profile(result.folder / "pnrvsa-best.toml");
    EXPECT_EQ(best.name, "pnrvsa-best");
    const auto& law = std::get<spring::StictionLawOptions>(best.law.curves);
    EXPECT_EQ(json["variables"][0]["found"], law.k);
    EXPECT_EQ(json["variables"][1]["found"], law.u);
    EXPECT_EQ(json["variables"][2]["found"], law.c);
    const auto design = pipeline::resolve(best);
    ASSERT_TRUE(design);
    const actuator::Actuator& joint = design->actuator;
    EXPECT_NEAR(core::deg_from_rad(actuator::dead_band(joint, 1.0).linear), json["figures"][3]["found"].get<double>(), 1e-9);
}

TEST_F(Algorithm1Run, InTheShippedBoxBothCamsAreCutAndDrawn) {
    const Written result = written(run_algorithm_1, read(), into("out"));
    ASSERT_TRUE(result.found());
    EXPECT_FALSE(core::any_error(result.findings));
    const Json json = Json::parse(core::read_file(result.folder / "design.json"));
    for (const Json& cam : json["cams"]) {
        EXPECT_TRUE(cam["can_be_cut"]) << cam["part"];
        EXPECT_EQ(cam["drawing"]["part"], cam["part"]);
    }
}

TEST_F(Algorithm1Run, CamsThatCannotBeCutAreSaidSoWithTheBindingRule) {
    const Written result =
        written(run_algorithm_1, read({{"algorithm_1.u_Nm", "[0.0, 0.3]"}, {"algorithm_1.c_Nm", "[0.0, 0.5]"}}), into("out"));
    ASSERT_TRUE(result.found());
    ASSERT_TRUE(core::any_error(result.findings)) << "T falls as 1/tau^2: too steep for a convex K_SE on this spring";
    const Json json = Json::parse(core::read_file(result.folder / "design.json"));
    for (const core::Finding& finding : result.findings) {
        if (finding.severity != core::Severity::kError) continue;
        EXPECT_NE(json.dump().find(finding.rule), std::string::npos) << finding.rule;
        EXPECT_FALSE(finding.suggestion.empty());
    }
    EXPECT_TRUE(json["cams"][0]["drawing"].is_null());
    EXPECT_FALSE(json["cams"][0]["can_be_cut"]);
}

TEST_F(Algorithm1Run, SameBytesForAnyNumberOfThreads) {
    const profile::Profile profile = read();
    RunOptions one = into("one"), three = into("three");
    one.jobs = 1;
    three.jobs = 3;
    EXPECT_EQ(bytes_in(written(run_algorithm_1, profile, one).folder), bytes_in(written(run_algorithm_1, profile, three).folder));
}

TEST_F(Algorithm1Run, StoppedItWritesTheBestSoFarAndGoesOn) {
    const profile::Profile profile = read();
    const Written whole = written(run_algorithm_1, profile, into("whole"));
    RunOptions options = into("out");
    int done = 0;
    options.progress = [&](int generation, double) { done = generation; };
    options.stop = [&] { return done == 47; };
    const Written part = written(run_algorithm_1, profile, options);
    EXPECT_TRUE(part.found() && part.interrupted);
    EXPECT_TRUE(Json::parse(core::read_file(part.folder / "design.json"))["interrupted"]);
    options.stop = {};
    options.resume = true;
    const Written rest = written(run_algorithm_1, profile, options);
    EXPECT_FALSE(rest.interrupted);
    for (const char* file : {"pnrvsa-best.toml", "history.csv", "figure_9.csv"})
        EXPECT_EQ(core::read_file(rest.folder / file), core::read_file(whole.folder / file)) << file;

    profile::Profile other = profile;
    other.algorithm_1.weight_sensitivity = 0.2;
    EXPECT_THROW((void)run_algorithm_1(other, options), core::InvalidInput) << "a checkpoint of another cost";
}

TEST_F(Algorithm1Run, NoSpringsInTheBoxIsAFindingWhoseSuggestionHelps) {
    profile::Profile profile = read({{"algorithm_1.u_Nm", "[0.5, 0.6]"}});
    const Written none = written(run_algorithm_1, profile, into("out"));
    EXPECT_FALSE(none.found());
    ASSERT_EQ(none.findings.size(), 1u);
    EXPECT_EQ(none.findings[0].rule, "design.feasible");
    EXPECT_LT(none.findings[0].measured, 0.0);
    EXPECT_FALSE(fs::exists(folder_ / "out" / "pnrvsa-design"));
    // "algorithm_1.u_Nm = [0, x] and algorithm_1.c_Nm = [0, y]"
    ASSERT_EQ(std::sscanf(none.findings[0].suggestion.text().c_str(), "algorithm_1.u_Nm = [0, %lf] with algorithm_1.c_Nm = [0, %lf]",
                          &profile.algorithm_1.u.high, &profile.algorithm_1.c.high),
              2);
    profile.algorithm_1.u.low = 0.0;
    EXPECT_TRUE(run_algorithm_1(profile, into("out")).found());
}

TEST_F(Algorithm1Run, AWeightTooSmallIsAFindingWhoseSuggestionHelps) {
    profile::Profile profile = read(
        {{"algorithm_1.weight_sensitivity_Nm_per_rad", "1.0"}, {"algorithm_1.u_Nm", "[0.0, 0.3]"}, {"algorithm_1.c_Nm", "[0.0, 0.6]"}});
    const Written none = written(run_algorithm_1, profile, into("out"));
    EXPECT_FALSE(none.found());
    ASSERT_EQ(none.findings.size(), 1u);
    EXPECT_EQ(none.findings[0].rule, "design.weight");
    EXPECT_EQ(none.findings[0].measured, 1.0);
    ASSERT_EQ(std::sscanf(none.findings[0].suggestion.text().c_str(), "algorithm_1.weight_dead_band_per_rad = %lf",
                          &profile.algorithm_1.weight_dead_band),
              1);
    EXPECT_TRUE(run_algorithm_1(profile, into("out")).found());
}

TEST_F(Algorithm1Run, WhatAlgorithm1CannotTakeIsNamed) {
    expect_refused(read({{"rig.gear_friction_constant_Nm", "0.01"}}), "rig.gear_friction_constant_Nm");
    expect_refused(read({{"algorithm_1.c_Nm", "[0.4, 0.1]"}}), "algorithm_1.c_Nm");
    expect_refused(read({{"rig.gear_friction", "0.0"}}), "rig.gear_friction");
    profile::Profile elsewhere = read();
    elsewhere.law.start_torque = 0.1;  // the profile's own law does not exist there: no travel to be taken from it
    std::get<spring::StictionLawOptions>(elsewhere.law.curves).start_torque = 0.1;
    expect_refused(elsewhere, "algorithm_1.wanted_travel_deg");
}

TEST_F(Algorithm1Run, AProfileWithoutPartsGetsSpringsAlone) {
    profile::Profile profile = read();
    profile.has_parts = false;
    const Written result = written(run_algorithm_1, profile, into("out"));
    EXPECT_TRUE(result.found());
    EXPECT_TRUE(Json::parse(core::read_file(result.folder / "design.json"))["cams"].empty());
}

TEST_F(Algorithm1Run, FilesThatTheProfileNamesAreReachedFromTheNewPlace) {
    write("p/data/measured.csv", "tau_Nm,width_deg\n1.0,50\n1.5,20\n");
    const profile::Profile profile = read({{"simulate.measured", "\"data/measured.csv\""}});
    const Written result = written(run_algorithm_1, profile, into("out"));
    const profile::Profile best = profile::read_profile(result.folder / "pnrvsa-best.toml");
    EXPECT_EQ(best.simulate.measured.file, fs::path("../../p/data/measured.csv"));
    EXPECT_EQ(best.simulate.measured.y, profile.simulate.measured.y);
    EXPECT_EQ(moved(profile, folder_ / "p").simulate.measured.file, fs::path("data/measured.csv"));
}

}  // namespace
}  // namespace fusee::search::codesign
