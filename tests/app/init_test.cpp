#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "fusee/core/file.h"
#include "run.h"

namespace fusee::app {
namespace {

class Init : public Program {
protected:
    /// Types `lines` into the questions on a terminal; each \n is the key Enter, \004 the end of the input.
    [[nodiscard]] Ended type(const std::string& lines, const std::string& arguments) const {
        core::write_file(folder_ / "lines", lines);
        const std::string command = "cd '" + folder_.string() + "' && timeout 120 script -qec '" FUSEE_PROGRAM " init " + arguments +
                                    "' .typescript <lines >.stdout 2>&1";
        const int status = std::system(command.c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, core::read_file(folder_ / ".stdout"), ""};
    }
    [[nodiscard]] bool has(const std::string& name) const { return fs::exists(folder_ / name); }
};

TEST_F(Init, WritesAProfileThatMakeAccepts) {
    const Ended wrote = run("init mine.toml --torque 1 --friction 0.05 --cable 'dyneema 0.8' --shaft 6 --process fdm --yes");
    ASSERT_EQ(wrote.code, 0) << wrote.all();
    expect_words(wrote.out, {"written: mine.toml", "fusee make mine.toml", "0 rules not judged", "K_SE: torsion spring, wire",
                             "cost of both sides in material", "4 cams of pla, ", " more pieces, ", "m of cable",
                             "prices and machine time are not known"});
    const std::string text = core::read_file(folder_ / "mine.toml");
    expect_words(text, {"name = \"mine\"", "gear_friction = 0.05", "diameter_mm = 0.8", "# mu: a resting capstan", "active_coils = "});
    const Ended made = run("make mine.toml");
    EXPECT_EQ(made.code, 0) << made.all();
    EXPECT_TRUE(has("out/mine/report.html"));
}

TEST_F(Init, AnExistingFileStaysAsItIs) {
    core::write_file(folder_ / "mine.toml", "mine");
    const Ended ended = run("init mine.toml --yes");
    EXPECT_EQ(ended.code, 2);
    expect_words(ended.err, {"mine.toml", "exists"});
    EXPECT_EQ(core::read_file(folder_ / "mine.toml"), "mine");
}

TEST_F(Init, BadOptionsAreAllNamed) {
    const Ended ended = run("init mine.toml --yes --torque 0 --cable 'rope 1' --process laser");
    EXPECT_EQ(ended.code, 2);
    expect_words(ended.err, {"--torque", "0.01 to 1000 Nm", "--cable", "dyneema", "--process", "fdm, sla, sls, mill, mill4"});
    EXPECT_FALSE(has("mine.toml"));
    EXPECT_EQ(run("init mine.txt --yes").code, 2);
    EXPECT_EQ(run("init '.toml' --yes").code, 2);
    EXPECT_EQ(run("init no_folder/mine.toml --yes").code, 2);
    EXPECT_EQ(run("init mine.toml --yes --overdrive 0.5").code, 2);
    const Ended formula = run("init mine.toml --kind spring --law '0.3+x' --from 0 --to 60 --columns 'angle_rad=W in deg' --yes");
    EXPECT_EQ(formula.code, 2);
    expect_words(formula.err, {"--columns", "only with a CSV file"});
}

TEST_F(Init, AsksOnATerminalAndAgainAfterABadAnswer) {
    if (std::system("command -v script >/dev/null") != 0) GTEST_SKIP() << "script(1) is missing";
    const Ended ended = type("much\n2\n\004", "mine.toml");
    expect_words(ended.out, {"Torque of one motor at the joint, held for long, Nm (0.01 to 1000) [1]: ",
                             "--torque: much (allowed: a number", "for a short time; 0 = 1.5 times as much"});
    EXPECT_NE(ended.code, 0);
    EXPECT_FALSE(has("mine.toml"));
    EXPECT_EQ(core::read_file(folder_ / "mine.toml.answers"), "--torque 2\n");
    const Ended later = type("1\n0\nback\nback\n3\n\004", "mine.toml");  // overdrive 1 is below the torque of 2
    expect_words(later.out, {"1 answer of the last session", "--torque 2", "--overdrive: 1 (allowed: 0, or at least --torque 2 Nm)",
                             "stopped: 1 answer kept in mine.toml.answers"});
    EXPECT_EQ(core::read_file(folder_ / "mine.toml.answers"), "--torque 3\n");
}

TEST_F(Init, ExplainsAQuestionAndChangesAnEarlierAnswer) {
    if (std::system("command -v script >/dev/null") != 0) GTEST_SKIP() << "script(1) is missing";
    const Ended ended = type("back\n--torque 2\n?\n2\n?\n--torque x\n--torque 4\n--bed 300\n\004", "mine.toml");
    expect_words(ended.out, {"this is the first question", "--torque 2: no question is answered yet: enter the value alone",
                             "What motor and gear hold", "What they give for seconds", "--torque: x", "changed: --torque 4",
                             "--bed 300: an option and its value; answered: --torque"});
    EXPECT_EQ(ended.code, 130);
    EXPECT_EQ(core::read_file(folder_ / "mine.toml.answers"), "--torque 4\n");
}

/// What the law cannot reach is told before part and shop are asked for.
TEST_F(Init, JudgesALawAtItsLastQuestion) {
    if (std::system("command -v script >/dev/null") != 0) GTEST_SKIP() << "script(1) is missing";
    std::string rows = "angle_rad,series_Nm,parallel_Nm\n";
    for (int i = 0; i <= 50; ++i) rows += fmt::format("{0},{1},{2}\n", 0.02 * i, 0.05 + 0.01 * i, 0.02 + 0.008 * i + 0.0001 * i * i);
    core::write_file(folder_ / "law.csv", rows);
    const Ended ended = type("0.5\n\n\n\n\nlaw.csv\n\n0.5\n0.38\n\n--torque 0.3\n\n\004", "mine.toml");
    expect_words(ended.out, {"--law: law.csv (allowed: springs of at least 1.5 Nm", "this joint cannot be made", "cover.greatest",
                             "  --overdrive 0.631 instead of 0.75"});
    expect_words(core::read_file(folder_ / "mine.toml.answers"), {"--torque 0.3\n", "--friction 0.38\n--friction-constant 0\n"});
}

TEST_F(Init, JudgesAFormulaAtItsQuestionAndAsksNoRangeOfAFile) {
    if (std::system("command -v script >/dev/null") != 0) GTEST_SKIP() << "script(1) is missing";
    core::write_file(folder_ / "law.csv", "angle [deg],torque [Nm]\n0,0.2\n9,0.21\n20,0.22\n30,0.23\n40,0.24\n50,0.25\n60,0.26\n70,0.27\n");
    const Ended ended =
        type("sin(\nnone.csv\nsqrt(x-1)\n0\n60\nback\n90\n180\n\nback\nback\nback\nback\nlaw.csv\nback\n\n\004", "mine.toml --kind spring");
    expect_words(ended.out, {"\"sin(\": Unexpected end", "cannot be opened for reading", "--law: \"sqrt(x-1)\" is ", " at x = 0"});
    EXPECT_EQ(core::read_file(folder_ / "mine.toml.answers"), "--law law.csv\n--from 0\n--to 0\n");
    (void)type("--law x\n\n180\n--law none.csv\n--law law.csv\n\004", "mine.toml --kind spring");  // a file after a formula with a range
    EXPECT_EQ(core::read_file(folder_ / "mine.toml.answers"), "--law law.csv\n--from 0\n--to 0\n");
}

TEST_F(Init, ASessionEndsWithTheCommandThatRepeatsIt) {
    if (std::system("command -v script >/dev/null") != 0) GTEST_SKIP() << "script(1) is missing";
    const std::string keys(15, '\n');  // all questions but the first
    (void)type("\n\004", "mine.toml");
    const Ended ended = type(keys + "back\nback\n260\n\n\n", "mine.toml");
    ASSERT_EQ(ended.code, 0) << ended.all();
    expect_words(ended.out, {"1 answer of the last session, the defaults;", "this joint can be made:", "Enter writes mine.toml",
                             "written: mine.toml", "fusee init mine.toml --bed 260 --yes"});
    EXPECT_FALSE(has("mine.toml.answers"));
    const std::string asked = core::read_file(folder_ / "mine.toml");
    ASSERT_EQ(run("init mine.toml --bed 260 --yes --force").code, 0);
    EXPECT_EQ(core::read_file(folder_ / "mine.toml"), asked);
}

TEST_F(Init, AnImpossibleJointWritesNothing) {
    const Ended ended = run("init mine.toml --yes --torque 10 --cable 'steel 3' --shaft 20");
    EXPECT_EQ(ended.code, 1);
    expect_words(ended.err,
                 {"this joint cannot be made", "limit.", "each of these alone meets it", "--bed", "instead of 200", "nothing is written"});
    EXPECT_FALSE(has("mine.toml"));
}

/// A parallel spring of constant torque: no choice of cams helps, so none is tried.
TEST_F(Init, ALawThatIsNoPairOfSpringsIsRefusedAtOnce) {
    std::string rows = "angle_rad,series_Nm,parallel_Nm\n";
    for (int i = 0; i <= 50; ++i) rows += std::to_string(0.02 * i) + "," + std::to_string(0.05 + 0.01 * i) + ",1.0\n";
    core::write_file(folder_ / "law.csv", rows);
    const Ended ended = run("init mine.toml --yes --torque 0.5 --law law.csv --repair");
    EXPECT_EQ(ended.code, 1);
    expect_words(ended.err, {"law.stiffness", "parallel_Nm", "no change of a single answer meets this", "nothing is written"});
    EXPECT_FALSE(has("mine.toml"));
    EXPECT_FALSE(has("mine-law.csv"));
}

}  // namespace
}  // namespace fusee::app
