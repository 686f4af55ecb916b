#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "app/run.h"

// From a diagnosis to a corrected profile: `diagnose --profile --write-profile`.
namespace fusee::app {
namespace {

class CorrectedProfile : public Program {
protected:
    /// A case of the shipped joint with break-aways alone, whose friction is 1.3 times the nominal one.
    void SetUp() override {
        Program::SetUp();
        write("rig/p.toml", core::read_file(fixtures::shipped("pnrvsa")));
        ASSERT_EQ(run("case-template rig/p.toml --out case").code, 0);
        const std::string toml = core::read_file(folder_ / "case" / "case.toml");
        write("case/case.toml", toml.substr(0, toml.find("[experiments]")) + "[experiments]\nbreakaway = \"breakaway.csv\"\n");
        std::istringstream rows(core::read_file(folder_ / "case" / "breakaway.csv"));
        std::string csv, line;
        std::getline(rows, csv);
        for (int i = 0; std::getline(rows, line); ++i) {
            const double motor = std::stod(line.substr(line.find(',', line.find(',') + 1) + 1));
            const double mu = 1.3 * 0.28 * (1.0 + 0.02 * (i % 4 - 1.5));  // repeats scatter
            csv += fmt::format("\n{}{}", line, motor / (line.find("backdrive") != std::string::npos ? 1.0 - mu : 1.0 + mu));
        }
        write("case/breakaway.csv", csv + "\n");
    }
};

TEST_F(CorrectedProfile, IsWrittenAndCanBeCut) {
    const Ended found = run("diagnose case --out d --profile rig/p.toml --write-profile new/p.toml --jobs 1");
    ASSERT_EQ(found.code, 0) << found.all();
    expect_words(found.out, {"dead-band error against the profile", "at peak torque, 1 Nm: exact dead-band as in fusee make 51.3 deg",
                             "profile for both sides: new/p.toml", "covers co-contractions of 0.8",
                             "of the 0.85 to 1.5 Nm in use: friction lets", "diagnosis.json, redesign.json"});
    const std::string toml = core::read_file(folder_ / "new" / "p.toml");
    expect_words(toml, {"# gear_friction was 0.28: gear.load_friction on both sides", "name = \"pnrvsa-redesign\"\n"});
    const auto json = nlohmann::json::parse(core::read_file(folder_ / "d" / "redesign.json"));
    EXPECT_LT(json["off_with_new_cams"].get<double>(), 0.5 * json["off_with_old_cams"].get<double>());
    expect_words(core::read_file(folder_ / "d" / "diagnosis.html"),
                 {"id=\"redesign\">{\"profile\"", "id=\"joint-scene\"", "\"capstan_agonist\"", "\"motor_shaft_agonist\""});
    EXPECT_EQ(core::read_file(folder_ / "rig" / "p.toml"), core::read_file(fixtures::shipped("pnrvsa")));
    const Ended made = run("make new/p.toml --out out");
    EXPECT_EQ(made.code, 0) << made.all();
    EXPECT_TRUE(fs::exists(folder_ / "out" / "pnrvsa-redesign" / "k_se.stl"));
}

TEST_F(CorrectedProfile, WhatDoesNotBelongTogetherIsRefusedBeforeTheDiagnosis) {
    const auto expect_refused = [&](const std::string& options, std::initializer_list<std::string> words) {
        const Ended refused = run("diagnose case --out d " + options);
        EXPECT_EQ(refused.code, 2) << refused.all();
        expect_words(refused.err, words);
        EXPECT_FALSE(fs::exists(folder_ / "d"));
    };
    expect_refused("--write-profile q.toml", {"--profile"});
    expect_refused("--profile rig/p.toml --write-profile rig/../rig/p.toml", {"--write-profile", "a file other than"});
    expect_refused("--profile none.toml --write-profile q.toml", {"none.toml"});
    write("rig/q.toml", fixtures::with_key(core::read_file(folder_ / "rig" / "p.toml"), "rig.capstan_radius_mm", "15"));
    expect_refused("--profile rig/q.toml --write-profile r.toml", {"rig.capstan_radius_mm: 15", "the case's 30 within 1.2 %"});
}

}  // namespace
}  // namespace fusee::app
