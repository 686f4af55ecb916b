#include "fusee/core/process.h"

#include <gtest/gtest.h>

#include <chrono>

#include "fusee/core/error.h"

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
