#include <gtest/gtest.h>

#include "fusee/core/text.h"

namespace fusee::core {
namespace {

TEST(Nearest, DistanceCountsLettersAndSwaps) {
    EXPECT_EQ(edit_distance("", ""), 0u);
    EXPECT_EQ(edit_distance("make", "make"), 0u);
    EXPECT_EQ(edit_distance("make", "mke"), 1u);
    EXPECT_EQ(edit_distance("make", "mkae"), 1u) << "two letters swapped";
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
    EXPECT_EQ(edit_distance("", "abc"), 3u);
}

TEST(Nearest, NamesAreNearByAThirdOfTheirLetters) {
    const std::vector<std::string> names{"make", "check", "diagnose", "predict", "case-template"};
    EXPECT_EQ(near_names("mkae", names), std::vector<std::string>{"make"});
    EXPECT_EQ(near_names("Diagnos", names), std::vector<std::string>{"diagnose"});
    EXPECT_EQ(near_names("case", names), std::vector<std::string>{"case-template"}) << "a beginning";
    EXPECT_TRUE(near_names("xyzzy", names).empty());
    EXPECT_TRUE(near_names("", names).empty());
    EXPECT_TRUE(near_names(std::string(100'000, 'x'), names).empty());
}

TEST(Nearest, AsksWithEachNameOnce) {
    EXPECT_EQ(did_you_mean("stl", {"scad"}), "");
    EXPECT_EQ(did_you_mean("stll", {"stl", "stl", "step"}, "\""), "; did you mean \"stl\"?");
    EXPECT_EQ(did_you_mean("mill", {"mill4", "mil"}), "; did you mean mill4 or mil?");
    EXPECT_EQ(near_names("aaa", {"aab", "aac", "aad", "aae"}, 2).size(), 2u);
}

}  // namespace
}  // namespace fusee::core
