#include <nlohmann/json.hpp>

#include "app/run.h"

namespace fusee::app {
namespace {

using Json = nlohmann::json;

fs::path example() { return fs::path(FUSEE_SOURCE_DIR) / "profiles" / "examples" / "coupon.csv"; }

TEST_F(Program, MakesCouponsAndCalibratesTheExample) {
    const std::string profile = fixtures::shipped("pnrvsa").string();
    const Ended made = run("coupons '" + profile + "'");
    ASSERT_EQ(made.code, 0) << made.all();
    EXPECT_TRUE(fs::exists(folder_ / "out" / "pnrvsa-coupons" / "COUPON.csv"));

    const Ended empty = run("calibrate out/pnrvsa-coupons/COUPON.csv");
    EXPECT_EQ(empty.code, 2) << "nothing is filled yet";
    expect_words(empty.err, {"COUPON.csv: measured", "no row is filled"});

    const Ended found = run("calibrate '" + example().string() + "' --profile '" + profile + "' --write-profile new.toml");
    ASSERT_EQ(found.code, 0) << found.all();
    expect_words(found.out, {"shrink_x", "bore_offset", "cable_axis", "-> compensation.cable_axis_mm", "written: new.toml"});
    // Golden: regenerate with the command of docs/guides/calibrate.md.
    EXPECT_EQ(core::read_file(folder_ / "new.toml"), core::read_file(example().parent_path() / "calibrated.toml"));
    const Json json = Json::parse(run("calibrate '" + example().string() + "' --json").out);
    EXPECT_EQ(json.at("figures").at(0).at("id"), "shrink_x");
    EXPECT_TRUE(json.at("figures").at(0).at("changes"));
}

TEST_F(Program, CalibrateNamesThePlaceOfWhatIsWrong) {
    write("c.csv", "item,given,given_unit,measured,unit\nlength_x,60,mm,59.8,inch\n");
    const Ended wrong = run("calibrate c.csv");
    EXPECT_EQ(wrong.code, 2);
    expect_words(wrong.err, {"c.csv:2:21: unit", "'inch'", "'mm'"});
    EXPECT_EQ(run("calibrate missing.csv").code, 2);
    const Ended alone = run("calibrate '" + example().string() + "' --write-profile new.toml");
    EXPECT_EQ(alone.code, 2);
    expect_words(alone.err, {"--profile"});
    write("sheet.csv", core::read_file(example()));
    const std::string pnrvsa = "'" + fixtures::shipped("pnrvsa").string() + "'";
    const Ended over = run("calibrate sheet.csv --profile " + pnrvsa + " --write-profile sheet.csv");
    EXPECT_EQ(over.code, 2) << "what was measured is not written over";
    expect_words(over.err, {"--write-profile: sheet.csv", ".toml"});
    EXPECT_EQ(core::read_file(folder_ / "sheet.csv"), core::read_file(example()));
    for (const char* command : {"coupons ", "calibrate sheet.csv --profile "}) {
        const Ended no_parts = run(command + ("'" + fixtures::shipped("relatives/series_elastic").string() + "'"));
        EXPECT_EQ(no_parts.code, 2);
        expect_words(no_parts.err, {"series_elastic.toml:", "rig.arrangement"});
    }
    write("one.csv", "item,given,given_unit,measured,unit\nlength_x,60,mm,59.8,mm\n");
    const Ended little = run("calibrate one.csv");
    EXPECT_EQ(little.code, 1) << little.all();
    expect_words(little.out, {"unknown: shrink_x: needs 3 rows length_x of 2 lengths that differ"});
}

}  // namespace
}  // namespace fusee::app
