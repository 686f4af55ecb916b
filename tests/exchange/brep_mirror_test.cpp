#include <gtest/gtest.h>

#include "brep/kernel/measure.h"
#include "fusee/cam/mirror.h"
#include "fusee/exchange/brep.h"
#include "fusee/solid/part.h"
#include "solid/fixture.h"

namespace fusee::exchange::brep {
namespace {

/// Meshes only have to bound the volume that a solid is compared with.
solid::PartOptions coarse() {
    solid::PartOptions o;
    o.chordal_error = 5e-6;
    return o;
}

// Two ways to the same solid: mirror it, or build it from the mirrored part.
TEST(Mirrored, IsTheSolidOfTheMirroredPart) {
    const solid::Part part = solid::build_part(solid::test::disc(0.014, 0.004), coarse()).value();
    const Brep solid = build(part).value();
    const auto image = mirrored(solid), built = build(solid::mirrored(part));
    ASSERT_TRUE(image) << core::to_line(image.refusal().front());
    ASSERT_TRUE(built) << core::to_line(built.refusal().front());
    EXPECT_EQ(image->faces, solid.faces);
    EXPECT_DOUBLE_EQ(image->deviation_mm, solid.deviation_mm);
    EXPECT_EQ(image->volume_mm3, solid.volume_mm3);
    EXPECT_NEAR(volume_mm3(*image->shape) / solid.volume_mm3, 1.0, 1e-8) << "turned outward again";
    EXPECT_NEAR(image->volume_mm3 / built->volume_mm3, 1.0, 1e-5);  // splines within 0.2 um on other nodes
}

// `build` holds every solid against its own mesh; here it is the left-handed one.
TEST(LeftHand, HelixOfThreeTurnsIsOneSolid) {
    const cam::Cam left = cam::mirrored(solid::test::snail(3.2, 4e-3, 0.5e-3));
    solid::PartOptions options = coarse();
    options.features.anchor_hole_diameter = 0.0;  // it would go through the turns above
    const solid::Part part = solid::build_part(left, options).value();
    const auto solid = build(part);
    ASSERT_TRUE(solid) << core::to_line(solid.refusal().front());
    EXPECT_LE(solid->faces, 50U);
    EXPECT_NEAR(solid->volume_mm3 / solid::volume_mm3(part.mesh), 1.0, 5e-4);
}

}  // namespace
}  // namespace fusee::exchange::brep
