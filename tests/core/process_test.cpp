#include "fusee/core/process.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <string>

#include "fusee/core/error.h"
#include "fusee/core/folder.h"

namespace fusee::core {
namespace {

using std::chrono::seconds;

TEST(Process, GivesCodeAndBothOutputs) {
    const ProcessResult result = run_process({"sh", "-c", "echo out; echo err >&2; exit 3"}, "a file", seconds(60));
    EXPECT_TRUE(result.in_time);
    EXPECT_EQ(result.code, 3);
    EXPECT_EQ(result.output, "out\nerr\n");
}

TEST(Process, ItsInputIsEmptyAndNoShellReadsItsWords) {
    EXPECT_EQ(run_process({"cat"}, "a file", seconds(60)).output, "");
    EXPECT_EQ(run_process({"echo", "$HOME; *"}, "a file", seconds(60)).output, "$HOME; *\n");
}

TEST(Process, EndsWhatTakesTooLong) {
    const ProcessResult result = run_process({"sleep", "600"}, "a file", seconds(0));
    EXPECT_FALSE(result.in_time);
    EXPECT_EQ(result.code, -1);
}

// A program that closes its output and goes on does not escape the limit.
TEST(Process, EndsWhatSleepsWithoutOutput) {
    const auto begin = std::chrono::steady_clock::now();
    const ProcessResult result = run_process({"sh", "-c", "exec >&- 2>&-; sleep 30"}, "a file", seconds(1));
    EXPECT_FALSE(result.in_time);
    EXPECT_EQ(result.code, -1);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, seconds(10));
    EXPECT_EQ(run_process({"sh", "-c", "exec >&- 2>&-; exit 7"}, "a file", seconds(60)).code, 7);
}

// What it left running holds the output open and is ended with it.
TEST(Process, EndsItsChildrenToo) {
    const auto begin = std::chrono::steady_clock::now();
    const ProcessResult result = run_process({"sh", "-c", "sleep 30 & echo $!"}, "a file", seconds(60));
    EXPECT_TRUE(result.in_time);
    EXPECT_EQ(result.code, 0);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, seconds(10));
    const pid_t grandchild = std::stoi(result.output);
    for (int i = 0; i < 1000 && ::kill(grandchild, 0) == 0; ++i) ::usleep(1000);
    std::string state = "gone";
    std::ifstream("/proc/" + std::to_string(grandchild) + "/stat") >> state >> state >> state;
    EXPECT_TRUE(state == "gone" || state == "Z") << state;
}

/// Is a process of this number there, and no zombie?
bool lives(pid_t process) {
    std::string state = "gone";
    std::ifstream("/proc/" + std::to_string(process) + "/stat") >> state >> state >> state;
    return state != "gone" && state != "Z";
}

// kill -9 leaves nobody who could end the called program: the kernel does.
TEST(Process, AProgramEndsWithTheProcessThatIsKilled) {
    if (!on_path("setpriv")) GTEST_SKIP() << "no setpriv (util-linux)";
    const TemporaryFolder folder;
    const std::string file = (folder.path() / "pid").string();
    const pid_t caller = ::fork();
    if (caller == 0) {
        (void)run_process({"sh", "-c", "echo $$ >'" + file + "'; exec sleep 600"}, "a file", seconds(600));
        ::_exit(0);
    }
    pid_t program = 0;
    for (int i = 0; i < 5000 && !(std::ifstream(file) >> program); ++i) ::usleep(1000);
    ASSERT_GT(program, 0);
    ::kill(caller, SIGKILL);
    for (int i = 0; i < 5000 && lives(program); ++i) ::usleep(1000);
    EXPECT_FALSE(lives(program));
    (void)::waitpid(caller, nullptr, 0);
}

TEST(Process, KeepsTheEndOfWhatIsPrintedWithoutEnd) {
    const ProcessResult endless = run_process({"yes"}, "a file", seconds(1), 1000);
    EXPECT_FALSE(endless.in_time);
    EXPECT_FALSE(endless.whole);
    EXPECT_EQ(endless.output.size(), 1000u);
    const ProcessResult ended = run_process({"sh", "-c", "seq 1 100000; echo last"}, "a file", seconds(60), 1000);
    EXPECT_EQ(ended.code, 0);
    EXPECT_FALSE(ended.whole);
    EXPECT_TRUE(ended.output.ends_with("100000\nlast\n"));
    EXPECT_TRUE(run_process({"seq", "1", "10"}, "a file", seconds(60), 1000).whole);
}

TEST(Process, HasAGroupAndALanguageOfItsOwn) {
    const ProcessResult group =
        run_process({"sh", "-c", "read pid name state parent group rest </proc/self/stat; echo $group"}, "a file", seconds(60));
    EXPECT_NE(std::stoi(group.output), ::getpgrp()) << "Ctrl-C at the terminal goes to fusee's group";
    ::setenv("LC_ALL", "xx_YY.UTF-8", 1);
    ::setenv("LC_NUMERIC", "xx_YY.UTF-8", 1);
    EXPECT_EQ(run_process({"sh", "-c", "echo $LC_ALL $LC_NUMERIC"}, "a file", seconds(60)).output, "C.UTF-8\n");
    ::unsetenv("LC_ALL");
    ::unsetenv("LC_NUMERIC");
}

TEST(Process, AProgramThatIsMissingNamesTheFile) {
    try {
        (void)run_process({"fusee-no-such-program"}, "part.scad", seconds(1));
        ADD_FAILURE();
    } catch (const IoError& error) {
        EXPECT_NE(std::string(error.what()).find("part.scad"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("fusee-no-such-program"), std::string::npos) << error.what();
    }
}

TEST(Process, OnPathKnowsWhatCanBeStarted) {
    EXPECT_TRUE(on_path("sh"));
    EXPECT_FALSE(on_path("fusee-no-such-program"));
}

TEST(Process, LastWordsAreShort) {
    EXPECT_EQ(last_words("short"), "short");
    const std::string tail = last_words(std::string(5000, 'a') + "b");
    EXPECT_EQ(tail.size(), 603u);
    EXPECT_TRUE(tail.starts_with("...a"));
    EXPECT_EQ(tail.back(), 'b');
}

}  // namespace
}  // namespace fusee::core
