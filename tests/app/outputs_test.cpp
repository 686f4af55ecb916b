#include "app/run.h"

// What a command replaces and what it leaves alone (docs/outputs.md), and what the environment may lack.
namespace fusee::app {
namespace {

class Outputs : public Program {
protected:
    /// A profile with another name, beside the test's other files.
    void lay(const std::string& file, const std::string& name, const fixtures::Changes& changes = {}) const {
        std::string text = fixtures::with_key(core::read_file(fixtures::shipped("pnrvsa")), "name", "\"" + name + "\"");
        write(file, fixtures::with_keys(fixtures::with_key(text, "outputs.formats", "[\"stl\"]"), changes));
    }
    /// `command` through the shell in the test's folder; $FUSEE is the program.
    [[nodiscard]] Ended shell(const std::string& command) const {
        const std::string out = (folder_ / ".stdout").string(), err = (folder_ / ".stderr").string();
        const std::string all = "cd '" + folder_.string() + "' && FUSEE='" FUSEE_PROGRAM "' && export FUSEE && ( " + command + " ) >'" +
                                out + "' 2>'" + err + "' </dev/null";
        const int status = std::system(all.c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, core::read_file(out), core::read_file(err)};
    }
    void expect_refused(const std::string& arguments, std::initializer_list<std::string> words) const {
        const Ended refused = run(arguments);
        EXPECT_EQ(refused.code, 2) << arguments << "\n" << refused.all();
        expect_words(refused.all(), words);
    }
};

TEST_F(Outputs, MakeKeepsWhatTheUserPutIntoTheFolder) {
    lay("a.toml", "arm");
    ASSERT_EQ(run("make a.toml").code, 0);
    write("out/arm/notes.txt", "mine");
    write("out/arm/k_se.gcode", "sliced by hand");
    ASSERT_EQ(run("make a.toml").code, 0);
    ASSERT_EQ(run("simulate a.toml").code, 0);
    EXPECT_EQ(core::read_file(folder_ / "out/arm/notes.txt"), "mine");
    EXPECT_EQ(core::read_file(folder_ / "out/arm/k_se.gcode"), "sliced by hand");
    write("out/arm/k_se.stl", "repaired");
    expect_refused("make a.toml", {"out/arm/k_se.stl", "was changed", "--force"});
    EXPECT_EQ(core::read_file(folder_ / "out/arm/k_se.stl"), "repaired");
    EXPECT_EQ(run("make a.toml --force").code, 0);
    EXPECT_NE(core::read_file(folder_ / "out/arm/k_se.stl"), "repaired");
    EXPECT_EQ(core::read_file(folder_ / "out/arm/notes.txt"), "mine");
}

TEST_F(Outputs, AFolderOfTheUsersIsRefusedByEveryCommand) {
    lay("a.toml", "src");
    write("src/main.cpp", "mine");
    write("src-coupons/x", "mine");
    write("src-design/x", "mine");
    write("identify-break_away/x", "mine");
    const std::string csv = "'" + (fs::path(FUSEE_SOURCE_DIR) / "profiles/examples/break_away.csv").string() + "'";
    const std::string bench = "'" + (fs::path(FUSEE_SOURCE_DIR) / "profiles/gap/paper_table_1").string() + "'";
    for (const std::string& arguments :
         {std::string("make a.toml --out ."), std::string("simulate a.toml --out ."), std::string("coupons a.toml --out ."),
          std::string("design a.toml --method algorithm_1 --out ."), "identify " + csv + " --out .",
          std::string("case-template a.toml --out src"), "diagnose " + bench + " --out src",
          "predict " + bench + " --inputs " + bench + " --out src", std::string("blind make --seed 1 --cases 1 --out src")}) {
        expect_refused(arguments, {"fusee did not make this folder", "Move the folder away"});
        expect_refused(arguments + " --force", {"fusee did not make this folder"});
    }
    EXPECT_EQ(core::read_file(folder_ / "src/main.cpp"), "mine");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "src"), fs::directory_iterator()), 1);
}

TEST_F(Outputs, AnotherProfilesFolderNeedsForce) {
    lay("a.toml", "arm");
    lay("b.toml", "arm");
    ASSERT_EQ(run("make a.toml").code, 0);
    expect_refused("make b.toml", {"out/arm", "a.toml", "b.toml", "--force"});
    expect_refused("simulate b.toml", {"a.toml", "b.toml", "--force"});
    EXPECT_EQ(run("make b.toml --force").code, 0);
    expect_refused("make a.toml", {"a.toml", "b.toml"});
}

TEST_F(Outputs, AFilledCouponSheetIsNeverReplaced) {
    lay("a.toml", "arm");
    ASSERT_EQ(run("coupons a.toml").code, 0);
    ASSERT_EQ(run("coupons a.toml").code, 0) << "nothing was filled in";
    write("out/arm-coupons/COUPON.csv", "measured");
    expect_refused("coupons a.toml", {"out/arm-coupons/COUPON.csv", "sheet to fill in"});
    expect_refused("coupons a.toml --force", {"out/arm-coupons/COUPON.csv", "sheet to fill in"});
    EXPECT_EQ(core::read_file(folder_ / "out/arm-coupons/COUPON.csv"), "measured");
}

TEST_F(Outputs, FilesThatTheUserNamesAreReplacedByForceOnly) {
    lay("a.toml", "arm");
    write("b.toml", "mine");
    const std::string sheet = "'" + (fs::path(FUSEE_SOURCE_DIR) / "profiles/examples/coupon.csv").string() + "'";
    const std::string profile = "'" + fixtures::shipped("pnrvsa").string() + "'";
    const std::string calibrate = "calibrate " + sheet + " --profile " + profile + " --write-profile b.toml";
    expect_refused("fix a.toml --out b.toml", {"b.toml: already exists", "--force"});
    expect_refused(calibrate, {"b.toml: already exists", "--force"});
    EXPECT_EQ(core::read_file(folder_ / "b.toml"), "mine");
    EXPECT_EQ(run(calibrate + " --force").code, 0);
    EXPECT_NE(core::read_file(folder_ / "b.toml"), "mine");
}

TEST_F(Outputs, AStoppedSearchIsNotLost) {
    lay("a.toml", "arm");
    const std::string design = "design a.toml --method algorithm_1 --population 8 --generations ";
    ASSERT_EQ(run(design + "2").code, 0);
    ASSERT_EQ(run(design + "3").code, 0) << "a search that was finished may be replaced";
    std::string checkpoint = core::read_file(folder_ / "out/arm-design.checkpoint");
    checkpoint.replace(checkpoint.find("\"finished\": true"), 16, "\"finished\": false");
    write("out/arm-design.checkpoint", checkpoint);
    expect_refused(design + "2", {"out/arm-design.checkpoint", "after 3 generations", "--resume", "--force"});
    EXPECT_EQ(core::read_file(folder_ / "out/arm-design.checkpoint"), checkpoint);
    EXPECT_EQ(run(design + "4 --resume").code, 0);
    write("out/arm-design.checkpoint", checkpoint);
    EXPECT_EQ(run(design + "2 --force").code, 0);
    write("out/arm-design.checkpoint", "mine");
    expect_refused(design + "2 --force", {"out/arm-design.checkpoint", "did not make this file"});
    write("mine.checkpoint", checkpoint);
    fs::remove(folder_ / "out/arm-design.checkpoint");
    fs::create_symlink(folder_ / "mine.checkpoint", folder_ / "out/arm-design.checkpoint");
    for (const char* how : {"2 --force", "4 --resume"}) expect_refused(design + how, {"out/arm-design.checkpoint", "is a link"});
    EXPECT_TRUE(fs::is_symlink(folder_ / "out/arm-design.checkpoint"));
}

TEST_F(Outputs, StandardOutputThatIsLostIsTold) {
    for (const char* command : {"rules", "rules --json", "keys", "--help", "--version", "completion bash"}) {
        const Ended full = shell(std::string("$FUSEE ") + command + " >/dev/full");
        EXPECT_EQ(full.code, 2) << command;
        expect_words(full.err, {"No space left on device"});
    }
    EXPECT_EQ(shell("$FUSEE rules >&-").code, 2);
    EXPECT_EQ(shell("$FUSEE no_command 2>/dev/full").code, 2);
    for (const char* command : {"rules", "--help", "no_command", "rules --json"}) {  // standard error is lost too
        EXPECT_EQ(shell(std::string("$FUSEE ") + command + " >/dev/full 2>&1").code, 2) << command;
        EXPECT_EQ(shell(std::string("$FUSEE ") + command + " >&- 2>&-").code, 2) << command;
    }
    EXPECT_EQ(shell("ls -d fusee-crash-*").code, 2) << "there is none";
}

/// `ulimit -f` stands for a full disk: both end a write.
TEST_F(Outputs, AFullDiskIsNoBadInput) {
    lay("a.toml", "arm");
    for (const char* command : {"make a.toml", "simulate a.toml", "case-template a.toml --out t"}) {
        const Ended full = shell(std::string("(ulimit -f 1; $FUSEE ") + command + " --json) 2>&1 | cat");
        expect_words(full.out, {"\"verdict\": \"out of resources\"", "\"exit_code\": 2", "cannot be written"});
    }
    expect_words(shell("$FUSEE make missing.toml --json").out, {"\"verdict\": \"bad input\""});
}

TEST_F(Outputs, AReaderThatLeavesIsNoError) {
    const std::string gone = "bash -c 'exec 3> >(true); wait $!; ";  // it has ended before a line is written
    for (const char* command : {"rules", "rules --json", "keys", "--help", "completion bash"}) {
        const Ended ended = shell(gone + "$FUSEE " + command + " >&3'");
        EXPECT_EQ(ended.code, 0) << command;
        EXPECT_EQ(ended.err, "") << command;
        EXPECT_EQ(shell(gone + "$FUSEE " + command + " >&3 2>&3'").code, 0) << command;
    }
    lay("a.toml", "arm");
    EXPECT_EQ(shell(gone + "$FUSEE make a.toml >&3'").code, 0);
    EXPECT_TRUE(fs::exists(folder_ / "out/arm/report.html")) << "what was asked for is written";
    EXPECT_EQ(shell(gone + "$FUSEE check missing.toml >&3 2>&3'").code, 2) << "the command's own code";
    EXPECT_EQ(shell("ls -d fusee-crash-*").code, 2) << "there is none";
}

TEST_F(Outputs, ALimitOfTheShellIsNamed) {
    lay("a.toml", "arm");
    const Ended large = shell("bash -c 'ulimit -f 20; $FUSEE make a.toml'");
    EXPECT_EQ(large.code, 2) << large.all();
    expect_words(large.err, {"File too large", "ulimit -f"});
    EXPECT_FALSE(fs::exists(folder_ / "out/arm"));
    const Ended late = shell("bash -c 'ulimit -t 2; $FUSEE budget a.toml --draws 100000'");
    EXPECT_EQ(late.code, 2) << late.all();
    expect_words(late.err, {"out of processor time", "ulimit -t"});
}

TEST_F(Outputs, WhatTheEnvironmentLacksIsNamed) {
    lay("a.toml", "arm", {{"outputs.formats", "[\"ngc\"]"}});
    expect_refused("make a.toml --jobs 100000", {"--jobs", "1024"});
    const Ended gone = shell("mkdir gone && cd gone && rmdir ../gone && $FUSEE make '" + (folder_ / "a.toml").string() + "' --out x");
    EXPECT_EQ(gone.code, 2) << gone.all();
    expect_words(gone.err, {"the working folder no longer exists"});
    if (shell("command -v rs274").code != 0) GTEST_SKIP() << "rs274 is not installed";
    const Ended tmp = shell("TMPDIR=/missing/folder $FUSEE make a.toml");
    EXPECT_EQ(tmp.code, 2) << tmp.all();
    expect_words(tmp.err, {"TMPDIR=/missing/folder"});
}

// No limit of processes holds root back.
TEST_F(Outputs, NoThreadIsAnErrorOfTheEnvironment) {
    lay("a.toml", "arm");
    const auto limited = [&](const std::string& arguments) {
        const std::string run = "bash -c 'ulimit -u 1; exec \"$FUSEE\" " + arguments + "'";
        return shell("chmod 755 . && if [ $(id -u) = 0 ]; then setpriv --reuid 65534 --clear-groups " + run + "; else " + run + "; fi");
    };
    if (limited("rules").code != 0) GTEST_SKIP() << "the number of processes cannot be limited here";
    const Ended none = limited("make a.toml");
    EXPECT_EQ(none.code, 2) << none.all();
    expect_words(none.err, {"no thread can be started", "ulimit -u"});
}

}  // namespace
}  // namespace fusee::app
