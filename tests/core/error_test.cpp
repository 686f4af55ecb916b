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

namespace fusee::core {
namespace {

TEST(Error, AFieldHoldsFileLineAndColumn) {
    const Location whole = location_of("some folder/p.toml:3:17: cable.diameter_mm");
    EXPECT_EQ(whole.file, "some folder/p.toml");
    EXPECT_EQ(whole.line, 3u);
    EXPECT_EQ(whole.column, 17u);
    EXPECT_EQ(whole.field, "cable.diameter_mm");
    const Location row = location_of("springs.csv:12: torque_Nm");
    EXPECT_EQ(row.file, "springs.csv");
    EXPECT_EQ(row.line, 12u);
    EXPECT_EQ(row.column, 0u);
    EXPECT_EQ(location_of("d.json: effects[0].side").file, "d.json");
    EXPECT_EQ(location_of("d.json: effects[0].side").field, "effects[0].side");
    EXPECT_EQ(location_of("rig.gear_friction").file, "");
    EXPECT_EQ(location_of("rig.gear_friction").field, "rig.gear_friction");
}

}  // namespace
}  // namespace fusee::core
