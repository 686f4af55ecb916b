#include "app/run.h"
#include "shipped.h"

// The paper anew, as a user sees it.
namespace fusee::app {
namespace {

const std::string kProfiles = "--profiles '" FUSEE_SOURCE_DIR "/profiles'";

TEST_F(Program, MakesThePaperAnewAndSaysWhatItFound) {
    const Ended made = run("paper " + kProfiles + " --out 'my paper'");
    EXPECT_EQ(made.code, 0) << made.all();
    expect_words(made.out, {"figure 1", "table II", "paper: ", "here: ", "written: my paper/paper/paper.html"});
    expect_words(made.err, {"paper 7/7"});
    EXPECT_TRUE(fs::exists(folder_ / "my paper" / "paper" / "table_1.csv"));
}

TEST_F(Program, PaperRefusesWrongArgumentsAndMissingProfiles) {
    const Ended missing = run("paper");
    EXPECT_EQ(missing.code, 2);
    EXPECT_EQ(missing.out, "");
    expect_words(missing.err, {"profiles/first_prototype.toml"});
    EXPECT_FALSE(fs::exists(folder_ / "out"));
    for (const char* arguments : {"paper x.toml", "paper --jobs -1", "paper --bar"}) EXPECT_EQ(run(arguments).code, 2) << arguments;
}

TEST_F(Program, APaperOfImpossibleSpringsEndsWith1) {
    fixtures::copy_shipped("profiles", folder_);
    write("profiles/pnrvsa.toml", fixtures::with_key(core::read_file(fixtures::shipped("pnrvsa")), "algorithm_1.c_Nm", "[0.7, 0.8]"));
    const Ended refused = run("paper");
    EXPECT_EQ(refused.code, 1) << refused.all();
    expect_words(refused.err, {"error: design.feasible", "pnrvsa"});
    EXPECT_FALSE(fs::exists(folder_ / "out"));
}

}  // namespace
}  // namespace fusee::app
