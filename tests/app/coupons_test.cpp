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
    const Json json = result_of(run("calibrate '" + example().string() + "' --json"));
    EXPECT_EQ(json.at("figures").at(0).at("id"), "shrink_x");
    EXPECT_TRUE(json.at("figures").at(0).at("changes"));
}

TEST_F(Program, AnInspectionSheetIsWrittenFilledAndReadBack) {
    const fs::path filled = example().parent_path() / "k_pe_inspection.csv";
    const std::string profile = fixtures::shipped("pnrvsa").string();
    const Ended found = run("calibrate '" + filled.string() + "' --profile '" + profile + "' --write-profile new.toml");
    ASSERT_EQ(found.code, 0) << found.all();
    expect_words(found.out, {"contour_offset", "-> compensation.k_pe_contour_mm", "rotation", "inspection.eccentricity", "% as made"});
    EXPECT_NE(core::read_file(folder_ / "new.toml").find("k_pe_contour_mm = 0.14"), std::string::npos);

    const Ended made = run("make '" + profile + "'");
    ASSERT_EQ(made.code, 0) << made.all();
    const fs::path sheet = folder_ / "out" / "pnrvsa" / "k_se_inspection.csv";
    const Ended empty = run("calibrate out/pnrvsa/k_se_inspection.csv");
    EXPECT_EQ(empty.code, 2);
    expect_words(empty.err, {"k_se_inspection.csv: measured_deviation_mm", "no row of the contour is filled"});
    core::write_file(sheet, core::read_file(sheet) + "k_se,contour,26,1,0,0,0,8,-0.3,0.3,0.1\n");
    const Ended again = run("make '" + profile + "' --force");
    EXPECT_EQ(again.code, 2) << "a filled sheet is never replaced";
    expect_words(again.err, {"k_se_inspection.csv", "is a sheet to fill in"});
    write("bad.csv", core::read_file(sheet) + "k_se,contour,27,1,0,0,0,8,-0.3,0.3,much\n");
    expect_words(run("calibrate bad.csv").err, {"bad.csv:36:36: measured_deviation_mm"});
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
