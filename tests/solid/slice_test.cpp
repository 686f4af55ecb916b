#include <gtest/gtest.h>

#include <cmath>

#include "fusee/core/units.h"
#include "fusee/solid/mesh.h"
#include "fusee/solid/outline.h"
#include "solid/fixture.h"

namespace fusee::solid {
namespace {

Ring regular(double radius, int corners) {
    Ring ring;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * core::kPi * i / corners;
        ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return ring;
}

TEST(Slice, OfAPrismIsItsPolygon) {
    const Mesh mesh = prism(regular(10.0, 12), -1.0, 2.0);
    const auto rings = slice(mesh, 0.3);
    ASSERT_EQ(rings.size(), 1u);
    double area = 0.0;
    for (std::size_t i = 0; i < rings[0].size(); ++i) {
        const auto &a = rings[0][i], &b = rings[0][(i + 1) % rings[0].size()];
        area += 0.5 * (a[0] * b[1] - b[0] * a[1]);
    }
    // A regular 12-gon of radius R has the area 3 R^2; sums of 24 products of some 100 mm^2 round to about 1e-12.
    EXPECT_NEAR(std::abs(area), 300.0, 1e-9);
    EXPECT_TRUE(slice(mesh, 2.5).empty());
}

TEST(Parallel, OfADiscIsASmallerCircleAboutItsCentre) {
    const auto line = parallel(test::disc(12e-3, 2e-3), {0.0, 2.0 * core::kPi}, -1e-3);
    ASSERT_EQ(line.size(), 721u);
    for (const auto& p : line) EXPECT_NEAR(std::hypot(p[0] - 2.0, p[1]), 11.0, 1e-12);  // rounding of some 10 mm
}

}  // namespace
}  // namespace fusee::solid
