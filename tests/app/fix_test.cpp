#include <nlohmann/json.hpp>

#include "app/run.h"

// The built program: a profile that cannot be made, its new profile, and what is left of it.
namespace fusee::app {
namespace {

using Json = nlohmann::json;

/// pnrvsa with one file to make, and with a groove so shallow that a deeper one leaves too little floor under the leg slot.
std::string spoiled() {
    return fixtures::with_keys(core::read_file(fixtures::shipped("pnrvsa")),
                               {{"outputs.formats", "[\"stl\"]"}, {"groove.depth_ratio", "0.3"}});
}

TEST_F(Program, FixesAProfileBesideTheOld) {
    write("t.toml", spoiled());
    const Ended fixed = run("fix t.toml --jobs 1");
    ASSERT_EQ(fixed.code, 0) << fixed.all();
    expect_words(fixed.out, {"fixed by 2 changes", "groove.depth_ratio = 0.375 (was 0.3)", "groove.depth", "the law is unchanged",
                             "written: t-fixed.toml"});
    EXPECT_EQ(core::read_file(folder_ / "t.toml"), spoiled()) << "the old profile stays as it is";
    expect_words(core::read_file(folder_ / "t-fixed.toml"),
                 {"# depth_ratio was 0.3: groove.depth", "chosen so that both cams can be made"});
    const Ended again = run("fix t-fixed.toml --json");
    ASSERT_EQ(again.code, 0) << again.all();
    const Json json = result_of(again);
    EXPECT_EQ(json.at("end"), "nothing to do");
    EXPECT_TRUE(json.at("changes").empty());
    EXPECT_FALSE(fs::exists(folder_ / "t-fixed-fixed.toml"));
}

TEST_F(Program, SaysWhatCannotBeFixed) {
    write("t.toml", fixtures::with_key(spoiled(), "cable.min_bend_ratio", "200"));
    const Ended refused = run("fix t.toml --out x.toml --most 20 --json");
    EXPECT_EQ(refused.code, 1) << refused.err;
    const Json json = result_of(refused);
    EXPECT_EQ(json.at("end"), "cannot be met");
    EXPECT_EQ(json.at("left").at(0).at("rule"), "cable.bend_ratio") << refused.out;
    EXPECT_FALSE(fs::exists(folder_ / "x.toml"));
}

TEST_F(Program, NeverFixesOverTheOldProfile) {
    write("t.toml", spoiled());
    const Ended wrong = run("fix t.toml --out ./t.toml");
    EXPECT_EQ(wrong.code, 2);
    expect_words(wrong.err, {"--out", "a file other than the profile"});
    EXPECT_EQ(core::read_file(folder_ / "t.toml"), spoiled());
}

// Before it searches: nobody waits for a file that cannot be.
TEST_F(Program, KnowsBeforeItFixesWhereItMayWrite) {
    write("t.toml", spoiled());
    write("data.csv", "1,2");
    fs::create_directories(folder_ / "dir.toml");
    for (const char* out : {"no/such.toml", "dir.toml", "t.toml/x.toml", "data.csv"}) {
        const Ended wrong = run(std::string("fix t.toml --out ") + out);
        EXPECT_EQ(wrong.code, 2) << out << wrong.all();
        expect_words(wrong.err, {out});
        EXPECT_EQ(wrong.err.find("judged"), std::string::npos) << wrong.err;
    }
    EXPECT_EQ(core::read_file(folder_ / "data.csv"), "1,2");
}

}  // namespace
}  // namespace fusee::app
