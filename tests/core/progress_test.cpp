#include "fusee/core/progress.h"

#include <gtest/gtest.h>

namespace fusee::core {
namespace {

/// Without a terminal, work that goes on under one label is one line; the count in it is that of its begin.
TEST(Progress, ReachWritesALineOnlyForANewLabel) {
    testing::internal::CaptureStderr();
    {
        Progress progress("init", 20);
        progress.reach(1, "search");
        progress.reach(2, "search");
        progress.reach(9, "search");
        progress.reach(20, "done");
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "init 1/20: search\ninit 20/20: done\n");
}

/// A search that begins again with better values reports less than before.
TEST(Progress, TheCountNeverFalls) {
    testing::internal::CaptureStderr();
    {
        Progress progress("init", 20);
        progress.reach(9, "search");
        progress.reach(2, "again");
        progress.reach(10, "springs");
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "init 9/20: search\ninit 9/20: again\ninit 10/20: springs\n");
}

TEST(Progress, AdvanceWritesALineForEachItem) {
    testing::internal::CaptureStderr();
    {
        Progress progress("make", 2);
        progress.advance("a.toml");
        progress.advance("a.toml");
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "make 1/2: a.toml\nmake 2/2: a.toml\n");
}

}  // namespace
}  // namespace fusee::core
