#include "fusee/core/isolated.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>

#include "fusee/core/error.h"

// What a child process does to itself does not reach its parent.
namespace fusee::core {
namespace {

using End = ChildResult::End;

ChildResult shell(const std::string& script, const ChildLimits& limits = {}) {
    return run_child({"/bin/sh", "-c", script}, "part.step", limits);
}

TEST(Isolated, GivesOutputAndCode) {
    const ChildResult result = shell("printf 'a\\0b'; echo no >&2; exit 4");
    EXPECT_EQ(result.end, End::kExited);
    EXPECT_EQ(result.code, 4);
    EXPECT_EQ(result.output, std::string("a\0b", 3));
}

TEST(Isolated, NamesTheSignalOfACrash) {
    const ChildResult result = shell("kill -SEGV $$");
    EXPECT_EQ(result.end, End::kSignalled);
    EXPECT_EQ(result.code, SIGSEGV);
}

TEST(Isolated, EndsWhatSleepsEvenWithItsOutputClosed) {
    ChildLimits limits;
    limits.clock = std::chrono::seconds(0);
    EXPECT_EQ(shell("exec sleep 600", limits).end, End::kOutOfTime);
    limits.clock = std::chrono::seconds(1);
    EXPECT_EQ(shell("exec sleep 600 >&-", limits).end, End::kOutOfTime);
}

TEST(Isolated, ProcessorTimeIsATimeLimit) { EXPECT_EQ(shell("ulimit -c 0; ulimit -S -t 1; while :; do :; done").end, End::kOutOfTime); }

TEST(Isolated, EndsWhatPrintsWithoutEnd) {
    ChildLimits limits;
    limits.output_bytes = 10'000'000;
    const ChildResult result = shell("exec cat /dev/zero", limits);
    EXPECT_EQ(result.end, End::kTooMuchOutput);
    EXPECT_LE(result.output.size(), limits.output_bytes);
}

TEST(Isolated, AProgramThatIsMissingNamesTheFile) {
    try {
        (void)run_child({"/no/such/program"}, "part.step", {});
        ADD_FAILURE();
    } catch (const IoError& error) {
        EXPECT_STREQ(error.what(), "part.step: the process that reads it cannot be started: No such file or directory");
    }
}

}  // namespace
}  // namespace fusee::core
