#include "app/run.h"

namespace fusee::app {
namespace {

constexpr const char* kStudy =
    "[study]\nbase = \"base.toml\"\noutputs = \"figures\"\n[vary]\nk_se.hub.bore_mm = [5.0, 6.0]\n"
    "[constraints]\nsmall = \"k_se.hub.bore_mm < 5.5\"\n";

class Batch : public Program {
protected:
    void SetUp() override {
        Program::SetUp();
        write("base.toml", fixtures::with_keys(core::read_file(fixtures::shipped("pnrvsa")), {{"tolerances.chordal_error_mm", "0.005"}}));
        write("two.toml", kStudy);
    }
    void expect_bad(const std::string& arguments, std::initializer_list<std::string> words) const {
        const Ended ended = run(arguments);
        EXPECT_EQ(ended.code, 2) << arguments << "\n" << ended.all();
        expect_words(ended.err, words);
    }
};

TEST_F(Batch, ADryRunListsTheDesignsAndMakesNothing) {
    const Ended ended = run("batch two.toml --dry-run");
    EXPECT_EQ(ended.code, 0);
    EXPECT_EQ(ended.out,
              "pnrvsa-bore_mm-5  k_se.hub.bore_mm = 5\npnrvsa-bore_mm-6  k_se.hub.bore_mm = 6  left out: small\n"
              "1 designs, 1 left out by constraints; about 3.0 kB on disk\n");
    EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(Batch, AStudyIsMadeIndexedAndAsked) {
    ASSERT_EQ(run("batch two.toml").code, 0);
    const Ended asked = run("query out/two \"SELECT name, outcome FROM designs\"");
    EXPECT_EQ(asked.code, 0);
    EXPECT_EQ(asked.out, "name\toutcome\npnrvsa-bore_mm-5\tmade\n");
    expect_words(run("batch two.toml").out, {"1 finished earlier"});
    expect_words(run("batch two.toml --merge").out, {"index of 1 designs; 0 are missing"});
}

// Of an endless statement a reader takes what it wants; --seconds ends one that prints nothing.
TEST_F(Batch, AQueryWithoutEndEnds) {
    write("figures.toml", "[study]\nbase = \"base.toml\"\noutputs = \"figures\"\n[vary]\nk_se.hub.bore_mm = [5.0]\n");
    ASSERT_EQ(run("batch figures.toml").code, 0);
    const std::string endless = "\"WITH RECURSIVE n(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM n) SELECT ";
    write("ask.sh", "set -o pipefail\n'" FUSEE_PROGRAM "' query out/figures " + endless + "x FROM n\" | head -n 3\n");
    const std::string command = "cd '" + folder_.string() + "' && timeout 60 bash ask.sh >answer 2>said";
    EXPECT_EQ(std::system(command.c_str()), 0);
    EXPECT_EQ(core::read_file(folder_ / "answer"), "x\n1\n2\n");
    EXPECT_EQ(core::read_file(folder_ / "said"), "");
    expect_bad("query out/figures --seconds 1 " + endless + "max(x) FROM n\"", {"longer", "--seconds"});
}

TEST_F(Batch, OptionsThatContradictEachOtherAreRefused) {
    expect_bad("batch two.toml --dry-run --merge", {"--dry-run", "--merge"});
    expect_bad("batch two.toml --shard 1/2 --merge", {"--shard", "--merge"});
    expect_bad("batch two.toml --slurm --shard 1/2", {"--shard", "--slurm"});
    expect_bad("batch two.toml --slurm-tasks 4", {"--slurm"});
    expect_bad("batch two.toml --slurm --slurm-tasks -4", {"--slurm-tasks", "0 to 1000"});
    expect_bad("batch two.toml base.toml", {"one study, or profiles"});
    EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(Batch, AMergeWithoutFinishedDesignsIsRefused) {
    expect_bad("batch two.toml --merge", {"--merge", "out/two", "finished designs"});
    EXPECT_FALSE(fs::exists(folder_ / "out/two/index.csv"));
}

TEST_F(Batch, AnIndexThatIsNoneIsNamed) {
    write("base.index", "no index");
    expect_bad("query base.index 'SELECT 1'", {"base.index", "not the index of a study"});
    expect_bad("query base.toml 'SELECT 1'", {"base.toml is a profile", "the folder that fusee batch wrote"});
    expect_bad("query out/two 'SELECT 1'", {"out/two", "fusee batch"});
}

TEST_F(Batch, AWrongValueNamesTheStudy) {
    write("two.toml", "[study]\nbase = \"base.toml\"\noutputs = \"figures\"\n[vary]\ncable.diameter_mm = [-1.0]\n");
    expect_bad("batch two.toml", {"two.toml: vary.cable.diameter_mm: -1"});
}

}  // namespace
}  // namespace fusee::app
