#include "fusee/core/kept.h"

#include <gtest/gtest.h>

#include <string>

namespace fusee::core {
namespace {

TEST(Kept, ForgetsWhatWasNotAskedForTheLongest) {
    Kept<std::string, int> kept(2);
    EXPECT_FALSE(kept.find("a"));
    kept.keep("a", 1);
    kept.keep("b", 2);
    EXPECT_EQ(kept.find("a"), 1);
    kept.keep("c", 3);
    EXPECT_EQ(kept.find("a"), 1);
    EXPECT_FALSE(kept.find("b"));
    EXPECT_EQ(kept.find("c"), 3);
}

}  // namespace
}  // namespace fusee::core
