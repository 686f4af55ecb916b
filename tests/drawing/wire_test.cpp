#include <gtest/gtest.h>

#include <cmath>

#include "fusee/core/units.h"
#include "fusee/drawing/picture.h"

namespace fusee::drawing {
namespace {

// Eight sides: the area of the wire's section is 8/2 r^2 sin 45 deg.
TEST(Tube, IsClosedAndHoldsItsSectionTimesItsLength) {
    const solid::Mesh mesh = tube({{0, 0, 0}, {0, 0, 4}, {0, 0, 10}}, 2.0);
    EXPECT_TRUE(solid::is_closed_and_oriented(mesh.triangles));
    EXPECT_NEAR(solid::volume_mm3(mesh), 10.0 * 4.0 * 4.0 * std::sqrt(0.5), 1e-9);
}

TEST(CoilMesh, HoldsTheWireOfItsTurnsBetweenItsEnds) {
    const Coil coil{9.0, 2.0, 46.0, 8.0, false};
    const solid::Mesh mesh = coil_mesh(coil);
    EXPECT_TRUE(solid::is_closed_and_oriented(mesh.triangles));
    const double length = std::hypot(coil.turns * core::kTurn * coil.mean_radius_mm, coil.length_mm - coil.wire_mm);
    EXPECT_NEAR(solid::volume_mm3(mesh) / (length * 4.0 * std::sqrt(0.5)), 1.0, 6e-3);  // chords of 10 degrees
    const solid::Box box = solid::bounding_box(mesh);
    EXPECT_NEAR(box.low_mm[2], 0.0, 0.05);
    EXPECT_NEAR(box.high_mm[2], 46.0, 0.05);
    EXPECT_NEAR(box.high_mm[0], 10.0, 0.02);
}

// A quarter turn from (r, 0): to (0, r) of a right-hand coil, to (0, -r) of a left-hand one.
TEST(CoilMesh, TurnsToItsHand) {
    const Coil right{9.0, 1.0, 10.0, 0.25, false};
    Coil left = right;
    left.left_hand = true;
    EXPECT_GT(solid::bounding_box(coil_mesh(right)).high_mm[1], 9.0);
    EXPECT_LT(solid::bounding_box(coil_mesh(left)).low_mm[1], -9.0);
}

}  // namespace
}  // namespace fusee::drawing
