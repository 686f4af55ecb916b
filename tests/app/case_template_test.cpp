#include "app/run.h"

// The empty gap case of a profile's joint, as a user sees it.
namespace fusee::app {
namespace {

TEST_F(Program, WritesAnEmptyCaseAndNeverOverAnotherOne) {
    const std::string profile = "'" + fixtures::shipped("pnrvsa").string() + "'";
    const Ended made = run("case-template " + profile + " --out 'my bench'");
    EXPECT_EQ(made.code, 0) << made.all();
    EXPECT_EQ(made.err, "");
    expect_words(made.out, {"pnrvsa: an empty case", "begin with BENCH.md", "written: my bench/"});
    for (const char* file : {"case.toml", "nominal_springs.csv", "breakaway.csv", "spring_pull.csv", "dead_band.csv", "joint_stiffness.csv",
                             "cocontraction.csv", "log.csv", "BENCH.md"})
        EXPECT_TRUE(fs::exists(folder_ / "my bench" / file)) << file;
    const auto before = fixtures::contents(folder_ / "my bench");
    EXPECT_EQ(run("case-template " + profile + " --out 'my bench'").code, 0) << "no sheet is filled in yet";
    write("my bench/breakaway.csv", before.at("breakaway.csv") + "measured");
    for (const char* force : {"", " --force"}) {
        const Ended again = run("case-template " + profile + " --out 'my bench'" + force);
        EXPECT_EQ(again.code, 2) << again.all();
        expect_words(again.err, {"my bench/breakaway.csv", "sheet to fill in", "Move it, or choose another folder"});
    }
    EXPECT_EQ(core::read_file(folder_ / "my bench" / "breakaway.csv"), before.at("breakaway.csv") + "measured");
    EXPECT_EQ(run("case-template " + profile + " --out second").code, 0);
    EXPECT_EQ(fixtures::contents(folder_ / "second"), before);
}

TEST_F(Program, CaseTemplateRefusesBadInputAndWritesNothing) {
    EXPECT_EQ(run("case-template").code, 2);
    EXPECT_EQ(run("case-template missing.toml --out case").code, 2);
    const std::string text = core::read_file(fixtures::shipped("pnrvsa"));
    write("t.toml", fixtures::with_key(text, "rig.gear_friction_constant_Nm", "0.01"));
    const Ended refused = run("case-template t.toml --out case");
    EXPECT_EQ(refused.code, 2) << refused.all();
    expect_words(refused.err, {"t.toml:", "rig.gear_friction_constant_Nm", "in proportion to the load"});
    EXPECT_FALSE(fs::exists(folder_ / "case"));
}

}  // namespace
}  // namespace fusee::app
