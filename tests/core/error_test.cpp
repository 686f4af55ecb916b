#include "fusee/core/error.h"

#include <gtest/gtest.h>

namespace fusee::core {
namespace {

TEST(Mistakes, AreThrownTogether) {
    Mistakes mistakes;
    EXPECT_TRUE(mistakes.collect([] {}));
    EXPECT_NO_THROW(mistakes.throw_if_any());
    EXPECT_FALSE(mistakes.collect([] { throw InvalidInput("a.toml:1: x", "-1", "above 0"); }));
    EXPECT_THROW(mistakes.throw_if_any(), InvalidInput);
    mistakes.add(InvalidInput("a.toml:7: y", "missing", "a number"));
    try {
        mistakes.throw_if_any();
        FAIL();
    } catch (const InvalidInputs& e) {
        EXPECT_EQ(e.all().size(), 2u);
        EXPECT_STREQ(e.what(), "2 mistakes:\na.toml:1: x: -1 (allowed: above 0)\na.toml:7: y: missing (allowed: a number)");
    }
}

TEST(Mistakes, OfAnInnerReadingAreKept) {
    Mistakes inner, outer;
    inner.add(InvalidInput("a", "1", "2"));
    inner.add(InvalidInput("b", "1", "2"));
    EXPECT_FALSE(outer.collect([&] { inner.throw_if_any(); }));
    EXPECT_THROW(outer.throw_if_any(), InvalidInputs);
}

}  // namespace
}  // namespace fusee::core
