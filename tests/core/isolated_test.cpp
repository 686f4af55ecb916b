#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <string>

#include "core/sanitizer.h"
#include "fusee/core/error.h"
#include "fusee/core/process.h"

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
        EXPECT_STREQ(error.what(), "part.step: /no/such/program cannot be started: it is not installed, or not on PATH");
    }
}

/// 0, or the number of the first step that a process could still do after it had closed the door.
int could_still(const std::string& fifo) {
    const int before = ::open("/dev/null", O_WRONLY);
    open_no_more_files();
    if (::open("/dev/null", O_RDONLY) >= 0 || errno != EMFILE) return 1;
    if (::open(fifo.c_str(), O_RDONLY) >= 0 || errno != EMFILE) return 2;  // without the limit it would wait for a writer
    if (::socket(AF_INET, SOCK_STREAM, 0) >= 0) return 3;
    if (std::system("/bin/cat /dev/null") == 0) return 4;
    limit_this_process({});
    if (::open("/dev/null", O_RDONLY) >= 0) return 5;
    return ::write(before, "a", 1) == 1 ? 0 : 6;
}

TEST(Isolated, OpensNothingBehindAClosedDoor) {
    if (kAddressSanitizer || kThreadSanitizer) GTEST_SKIP() << "no limit: the sanitizer opens files itself";
    const std::string fifo = testing::TempDir() + "fusee_fifo_" + std::to_string(::getpid());
    ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
    EXPECT_EXIT(::_exit(could_still(fifo)), testing::ExitedWithCode(0), "");
    ::unlink(fifo.c_str());
}

}  // namespace
}  // namespace fusee::core
