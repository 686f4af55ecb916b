#include "fusee/core/workers.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <limits>

namespace fusee::core {
namespace {

TEST(Workers, CountIsBounded) {
    EXPECT_EQ(worker_count(3, 100), 3u);
    EXPECT_EQ(worker_count(3, 2), 2u);
    EXPECT_EQ(worker_count(3, 0), 1u);
    EXPECT_GE(worker_count(0, 100), 1u);
    EXPECT_EQ(worker_count(std::numeric_limits<unsigned>::max(), 1'000'000), kMostWorkers);
}

TEST(Workers, AllWorkIsDone) {
    std::atomic<int> next{0}, sum{0};
    run_workers(4, [&] {
        for (int i = next++; i < 100; i = next++) sum += i;
    });
    EXPECT_EQ(sum, 4950);
}

// The address space ends before the stacks of so many threads fit into it.
TEST(Workers, FewerThreadsDoItWhereTheSystemGivesNoMore) {
    const pid_t child = ::fork();
    if (child == 0) {
        const rlimit little{500'000'000, 500'000'000};
        ::setrlimit(RLIMIT_AS, &little);
        std::atomic<int> next{0}, done{0};
        run_workers(kMostWorkers, [&] {
            for (int i = next++; i < 100; i = next++) ++done;
        });
        ::_exit(done == 100 ? 0 : 1);
    }
    int status = -1;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
}

}  // namespace
}  // namespace fusee::core
