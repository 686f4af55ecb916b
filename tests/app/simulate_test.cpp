#include <nlohmann/json.hpp>

#include "app/run.h"

// `fusee simulate` from outside: what it says, writes and refuses.
namespace fusee::app {
namespace {

TEST_F(Program, SimulatesAJointAndSaysSo) {
    const Ended done = run("simulate '" + fixtures::shipped("pnrvsa").string() + "' --levels 4 --out 'my joints'");
    EXPECT_EQ(done.code, 0) << done.all();
    expect_words(done.out,
                 {"pnrvsa.toml  simulated", "my joints/pnrvsa/", "measured",
                  "Condition (6) holds only within rounding from 0.85 Nm to 1.5 Nm", "up to a joint torque of 0.151 Nm", "levels=4"});
    for (const char* file : {"simulation.json", "dead_band.csv", "simulation.html"})
        EXPECT_TRUE(fs::exists(folder_ / "my joints" / "pnrvsa" / file)) << file;
}

TEST_F(Program, ResultsAndModelsForMujocoGoToTwoFolders) {
    const Ended refused = run("simulate '" + fixtures::shipped("pnrvsa").string() + "' --levels 2 --out same --write-mjcf same");
    EXPECT_EQ(refused.code, 2) << refused.all();
    expect_words(refused.err, {"--write-mjcf", "a folder other than --out"});
    EXPECT_FALSE(fs::exists(folder_ / "same"));
}

TEST_F(Program, EquilibriaAreFoundAtAnyTorques) {
    const std::string profile = "simulate '" + fixtures::shipped("pnrvsa").string() + "' --levels 2 ";
    const Ended done = run(profile + "--at 1.5,1.5,0 --at 1,0.9,-0.02");
    EXPECT_EQ(done.code, 0) << done.all();
    expect_words(done.out, {"at tau_1 = 1.5 Nm, tau_2 = 1.5 Nm, tau_q = 0 Nm", "q = 0 rad (0 deg)", "condition (5)", "in cable space",
                            "at tau_1 = 1 Nm, tau_2 = 0.9 Nm, tau_q = -0.02 Nm", "defined without joint torque only"});
    const auto json = nlohmann::json::parse(core::read_file(folder_ / "out" / "pnrvsa" / "simulation.json"));
    const auto &equal = json["equilibria"][0], &level = json["levels"][1];  // the greatest level: 1.5 Nm of both motors
    // The search ends where 1e-14 of the torques is left over; the softest motion yields about 4 rad/Nm.
    for (const int capstan : {0, 1}) EXPECT_NEAR(equal["z_rad"][capstan].get<double>(), level["capstan_rad"].get<double>(), 1e-12);
    EXPECT_NEAR(equal["z_rad"][2].get<double>(), 0.0, 1e-12);
    EXPECT_NEAR(equal["dead_band"]["linear_rad"].get<double>(), level["linear_rad"].get<double>(), 1e-10);
    EXPECT_NEAR(equal["dead_band"]["exact_rad"].get<double>(), level["exact_rad"].get<double>(), 1e-10);
    expect_words(core::read_file(folder_ / "out" / "pnrvsa" / "simulation.html"), {"\"equilibria\":[{"});

    const Ended refused = run(profile + "--at 5,1,0");
    EXPECT_EQ(refused.code, 1) << refused.all();
    expect_words(refused.err, {"pnrvsa.toml  refused", "equilibrium.outside", "at 5, 1, 0 Nm", "nearest feasible: tau_1 = 2."});
}

TEST_F(Program, ARelativeHasNoModelForMuJoCoAndLeavesNoFolder) {
    const fs::path relative = fs::path(FUSEE_SOURCE_DIR) / "profiles" / "relatives" / "bidirectional.toml";
    const Ended refused = run("simulate '" + relative.string() + "' --levels 2 --write-mjcf models");
    EXPECT_EQ(refused.code, 2) << refused.all();
    expect_words(refused.err, {"rig.arrangement", "for a model for MuJoCo"});
    EXPECT_FALSE(fs::exists(folder_ / "models"));
    EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(Program, RelativesEndInOneTable) {
    const Ended done = run("simulate '" + (fs::path(FUSEE_SOURCE_DIR) / "profiles" / "relatives").string() + "' --levels 2");
    EXPECT_EQ(done.code, 0) << done.all();
    const std::string csv = core::read_file(folder_ / "out" / "relatives.csv");
    for (const std::string arrangement :
         {"pnrvsa", "series_elastic", "simple_antagonist", "quasi_antagonist", "bidirectional", "cross_coupled"}) {
        expect_words(done.out, {" " + arrangement + " "});
        expect_words(csv, {"," + arrangement + ","});
    }
    expect_words(csv, {"name,arrangement,stiffness_low_Nm_per_rad,"});
}

// A written profile has a name of its own, so that it can lie beside its source and both are made into one folder.
TEST_F(Program, WrittenProfilesLieBesideTheirSource) {
    fs::create_directory(folder_ / "mine");
    write("mine/pnrvsa.toml", core::read_file(fixtures::shipped("pnrvsa")));
    for (const char* command : {"springs mine/pnrvsa.toml", "springs mine/pnrvsa-springs.toml"}) {
        const Ended found = run(command);
        EXPECT_EQ(found.code, 0) << found.all();
    }
    EXPECT_TRUE(fs::exists(folder_ / "mine" / "pnrvsa-springs-2.toml"));
    std::string bad = fixtures::with_key(core::read_file(fixtures::shipped("pnrvsa")), "k_se.features.anchor_hole_mm", "0.5");
    write("mine/pnrvsa.toml", bad);
    const Ended fixed = run("fix mine/pnrvsa.toml");
    EXPECT_EQ(fixed.code, 0) << fixed.all();
    const Ended done = run("simulate mine --levels 2");
    EXPECT_EQ(done.code, 0) << done.all();
    for (const char* name : {"pnrvsa", "pnrvsa-springs", "pnrvsa-springs-2", "pnrvsa-fixed"})
        EXPECT_TRUE(fs::exists(folder_ / "out" / name / "simulation.json")) << name;
}

TEST_F(Program, SimulateRefusesWithTheKeyAndWritesNothing) {
    const std::string text = core::read_file(fs::path(FUSEE_SOURCE_DIR) / "profiles" / "relatives" / "pnrvsa.toml");
    const auto expect_refused = [&](const std::string& key, const std::string& value, int code, std::initializer_list<std::string> words) {
        write("t.toml", fixtures::with_key(text, key, value));
        const Ended refused = run("simulate t.toml");
        EXPECT_EQ(refused.code, code) << refused.all();
        EXPECT_EQ(refused.out, "");
        expect_words(refused.err, words);
        EXPECT_FALSE(fs::exists(folder_ / "out"));
    };
    expect_refused("simulate.levels", "1", 2, {"t.toml:", "simulate.levels: 1", "2 to 1000"});
    expect_refused("rig.arrangement", "\"antagonist\"", 2, {"t.toml:", "rig.arrangement", "\"series_elastic\""});
    expect_refused("rig.gear_friction_constant_Nm", "-0.1", 2, {"t.toml:", "rig.gear_friction_constant_Nm: -0.1"});
    expect_refused("simulate.measured", "\"none.csv\"", 2, {"none.csv", "cannot be opened"});
    expect_refused("law.parallel_Nm", "[0.0, 0.25, -0.09]", 1, {"t.toml  refused", "law.stiffness"});
}

TEST_F(Program, MakeSaysWhatAProfileWithoutPartsLacks) {
    const fs::path profiles = fs::path(FUSEE_SOURCE_DIR) / "profiles";
    const Ended partless = run("make '" + (profiles / "paper" / "new_springs.toml").string() + "'");
    EXPECT_EQ(partless.code, 2) << partless.all();
    expect_words(partless.err, {"new_springs.toml: k_se.spring.rate_Nm_per_rad: missing", "can be simulated"});
    const Ended relative = run("make '" + (profiles / "relatives" / "bidirectional.toml").string() + "'");
    EXPECT_EQ(relative.code, 2) << relative.all();
    expect_words(relative.err, {"bidirectional.toml:", "rig.arrangement: bidirectional", "\"pnrvsa\""});
    EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(Program, SimulateArguments) {
    const std::pair<const char*, std::string> cases[] = {{"simulate", "at least one profile"},
                                                         {"simulate x.toml --levels 1", "--levels"},
                                                         {"simulate x.toml --levels two", "--levels"},
                                                         {"simulate x.toml --push-torque -1", "--push-torque"},
                                                         {"simulate x.toml --foo", "--foo"},
                                                         {"simulate x.toml --at 1,1", "--at: 1,1 ("},
                                                         {"simulate x.toml --at 1,1,0,0", "--at"},
                                                         {"simulate x.toml --at 1,1,nan", "--at"},
                                                         {"simulate x.toml --at 1,1,2e4", "from -10000 to 10000"},
                                                         {"simulate x.toml --at '1, 1, 0'", "--at"},
                                                         {"simulate x.toml --at 1,1,0 --at one,1,0", "--at: one,1,0 ("}};
    for (const auto& [arguments, word] : cases) {
        const Ended wrong = run(arguments);
        EXPECT_EQ(wrong.code, 2) << arguments;
        expect_words(wrong.err, {word});
    }
    expect_words(run("simulate --help").out, {"Usage: fusee simulate", "Example:\n  fusee simulate", "Exit code"});
}

}  // namespace
}  // namespace fusee::app
