#include <gtest/gtest.h>

#include <algorithm>

#include "fusee/checks/limits.h"
#include "fusee/core/error.h"

namespace fusee::checks {
namespace {

TEST(StandardSizes, AreTheNextOnThePermittedSide) {
    EXPECT_EQ(shaft_sizes().at_most(5.41), 5.0);
    EXPECT_EQ(shaft_sizes().at_least(5.41), 6.0);
    EXPECT_EQ(shaft_sizes().at_most(6.0), 6.0);
    EXPECT_EQ(shaft_sizes().at_least(6.0), 6.0);
    EXPECT_EQ(cable_sizes("7x7").at_most(0.462), 0.4);
    EXPECT_EQ(cable_sizes("fibre").at_least(0.81), 1.0);
    EXPECT_EQ(wire_sizes().at_least(1.01), 1.1);
}

TEST(StandardSizes, EndWithTheAvailableSizes) {
    EXPECT_FALSE(shaft_sizes().at_most(1.9));
    EXPECT_FALSE(shaft_sizes().at_least(51.0));
    EXPECT_FALSE(cable_sizes("7x19").at_most(0.5)) << "133 wires in half a millimetre";
    EXPECT_FALSE(cable_sizes("7x7").at_most(0.2));
}

/// 0.8 mm read from a profile and back misses 0.8 by its last bit.
TEST(StandardSizes, CountASizeThatMissesByRounding) {
    EXPECT_EQ(cable_sizes("fibre").at_most(0.8 * (1.0 - 1e-12)), 0.8);
    EXPECT_EQ(cable_sizes("fibre").at_least(0.8 * (1.0 + 1e-12)), 0.8);
}

TEST(StandardSizes, AscendAndNameTheirSource) {
    std::vector<StandardSizes> all{shaft_sizes(), wire_sizes(), screw_sizes()};
    for (const CableLimits& row : cable_table()) all.push_back(cable_sizes(row.construction));
    for (const StandardSizes& sizes : all) {
        EXPECT_TRUE(std::is_sorted(sizes.mm.begin(), sizes.mm.end())) << sizes.what;
        EXPECT_NE(std::string(sizes.source), "") << sizes.what;
    }
    EXPECT_THROW((void)cable_sizes("8x8"), core::InvalidInput);
}

/// DIN 6885 has a key for each shaft size between its ends.
TEST(StandardSizes, ShaftsHaveTheirKeys) {
    for (const double mm : shaft_sizes().mm) EXPECT_EQ(key_size(1e-3 * mm) != nullptr, mm >= 6.0 && mm <= 30.0) << mm;
}

TEST(StandardSizes, HaveAStrengthByTheSquareOfTheDiameter) {
    EXPECT_NEAR(strongest_cable("7x7", 1e-3), 900.0, 1e-9);
    EXPECT_NEAR(strongest_cable("fibre", 0.8e-3), 1324.8, 1e-9);
    EXPECT_NEAR(torsion_stress(1.0, 5e-3) / 1e6, 40.744, 1e-3) << "16/(pi 125)";
    EXPECT_LT(shaft_shear_limit(true), shaft_shear_limit(false));
}

}  // namespace
}  // namespace fusee::checks
