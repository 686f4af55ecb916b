#include <gtest/gtest.h>

#include <cmath>

#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "fusee/solid/part.h"

namespace fusee::solid {
namespace {

// Known: d = 1 mm, floor radius 0.53 mm, throat 90 deg: the arc ends 45 deg up, at depth 0.53 (1 - cos 45) and width 0.53 sin 45.
TEST(GrooveSection, HasARoundFloorAndStraightFlanks) {
    const auto section = groove_section({}, 1e-3, 1e-6);
    const std::size_t middle = section.size() / 2;
    EXPECT_EQ(section.size() % 2, 1u);
    EXPECT_NEAR(section[middle].offset_mm, -0.5, 1e-12);  // the floor's bottom holds the cable's centre at 0
    EXPECT_NEAR(section[middle].z_mm, 0.0, 1e-12);
    const double arc_depth = 0.53 * (1.0 - std::sqrt(0.5)), lip = 0.53 * std::sqrt(0.5) + (1.5 - arc_depth);
    EXPECT_NEAR(section.back().offset_mm, 1.0, 1e-12);
    EXPECT_NEAR(section.back().z_mm, lip, 1e-12);
    for (std::size_t i = 0; i < section.size(); ++i) {
        EXPECT_NEAR(section[i].z_mm, -section[section.size() - 1 - i].z_mm, 1e-12) << i;  // symmetric
        if (i == 0 || i + 1 == section.size()) continue;
        EXPECT_NEAR(std::hypot(section[i].offset_mm + 0.5 - 0.53, section[i].z_mm), 0.53, 1e-12) << i;  // on the arc
        if (i < 2) continue;
        const double sagitta = 0.53 - std::hypot(0.5 * (section[i].offset_mm + section[i - 1].offset_mm) + 0.5 - 0.53,
                                                 0.5 * (section[i].z_mm + section[i - 1].z_mm));
        EXPECT_LE(sagitta, 1e-3) << i;
        EXPECT_GE(sagitta, 0.0) << i;
    }
}

TEST(GrooveSection, RefusesADepthAboveTheArc) {
    GrooveOptions shallow;
    shallow.throat = 0.0;
    shallow.depth_ratio = 0.5;  // the half-round floor alone is 0.53 d deep
    EXPECT_THROW((void)groove_section(shallow, 1e-3, 1e-6), core::InvalidInput);
    EXPECT_THROW((void)groove_section({}, 0.0, 1e-6), core::InvalidInput);
    EXPECT_THROW((void)groove_section({}, 1e-3, 0.0), core::InvalidInput);
}

}  // namespace
}  // namespace fusee::solid
