#include "fusee/core/parallel.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <limits>
#include <vector>

#include "core/sanitizer.h"
#include "fusee/core/error.h"

namespace fusee::core {
namespace {

TEST(Parallel, WorkerCountIsBounded) {
    EXPECT_EQ(worker_count(3, 100), 3u);
    EXPECT_EQ(worker_count(3, 2), 2u);
    EXPECT_EQ(worker_count(3, 0), 1u);
    EXPECT_GE(worker_count(0, 100), 1u);
    EXPECT_EQ(worker_count(std::numeric_limits<unsigned>::max(), 1'000'000), kMostWorkers);
}

TEST(Parallel, EachIndexIsCalledOnce) {
    for (const unsigned jobs : {1u, 2u, 7u}) {
        std::vector<int> calls(1000, 0);
        parallel_for(calls.size(), jobs, [&](std::size_t i) { ++calls[i]; });
        EXPECT_EQ(calls, std::vector<int>(1000, 1)) << jobs;
    }
    parallel_for(0, 4, [](std::size_t) { FAIL(); });
}

TEST(Parallel, OneThreadKeepsTheOrder) {
    std::vector<std::size_t> order;
    parallel_for(5, 1, [&](std::size_t i) { order.push_back(i); });
    EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
}

TEST(Parallel, AnExceptionReachesTheCaller) {
    for (const unsigned jobs : {1u, 3u})
        EXPECT_THROW(parallel_for(50, jobs,
                                  [](std::size_t i) {
                                      if (i == 20) throw InvalidInput("a", "b", "c");
                                  }),
                     InvalidInput)
            << jobs;
}

// The address space ends before the stacks of so many threads fit into it.
TEST(Parallel, FewerThreadsDoItWhereTheSystemGivesNoMore) {
    if (kAddressSanitizer || kThreadSanitizer) GTEST_SKIP() << "the sanitizer reserves terabytes of address space";
    const pid_t child = ::fork();
    if (child == 0) {
        const rlimit little{500'000'000, 500'000'000};
        ::setrlimit(RLIMIT_AS, &little);
        std::atomic<int> done{0};
        parallel_for(100, kMostWorkers, [&](std::size_t) { ++done; });
        ::_exit(done == 100 ? 0 : 1);
    }
    int status = -1;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
}

}  // namespace
}  // namespace fusee::core
