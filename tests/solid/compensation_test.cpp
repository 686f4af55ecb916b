#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fusee/solid/mesh.h"
#include "fusee/solid/outline.h"
#include "fusee/solid/part.h"
#include "solid/fixture.h"

namespace fusee::solid {
namespace {

TEST(Compensation, AGrownMeshShrinksToTheNominalOne) {
    const Mesh box = prism({{10.0, -5.0}, {50.0, -5.0}, {50.0, 15.0}, {10.0, 15.0}}, -2.0, 8.0);
    const std::array<double, 3> shrink{0.004, 0.02, -0.003};
    const Mesh file = grown(box, shrink);
    ASSERT_EQ(file.triangles, box.triangles);
    for (std::size_t i = 0; i < box.points_mm.size(); ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)  // single precision of 50 mm: 2e-6
            EXPECT_NEAR(file.points_mm[i][axis] * (1.0 - shrink[axis]), box.points_mm[i][axis], 3e-6);
    EXPECT_NEAR(bounding_box(file).high_mm[0], 50.0 / 0.996, 3e-6) << "larger, not smaller";
    EXPECT_NEAR(bounding_box(file).high_mm[2], 8.0 / 1.003, 1e-6);
    EXPECT_TRUE(Compensation{}.none());
    EXPECT_FALSE((Compensation{{0.0, 0.0, 0.001}, 0.0}.none()));
}

double bore_radius(const Mesh& mesh) {
    double least = 1e9;
    for (const Vec3& p : mesh.points_mm) least = std::min(least, std::hypot(p[0], p[1]));
    return least;
}

TEST(Compensation, AWiderBoreMovesEveryWallOfItByHalfTheOffset) {
    PartOptions options = test::plain();
    options.chordal_error = 20e-6;
    for (const HubLock lock : {HubLock::kPlain, HubLock::kKeyway, HubLock::kDFlat}) {
        options.hub.lock = lock;
        const auto part = build_part(test::disc(), options);
        ASSERT_TRUE(part);
        const auto wider = with_wider_bore(*part, 0.2e-3);
        ASSERT_TRUE(wider);
        EXPECT_NEAR(bore_radius(wider->mesh) - bore_radius(part->mesh), 0.1, 1e-5);
        const double key = wider->options.hub.key_width - options.hub.key_width;
        EXPECT_NEAR(key, lock == HubLock::kKeyway ? 0.2e-3 : 0.0, 1e-15);
        EXPECT_EQ(bounding_box(wider->mesh).high_mm, bounding_box(part->mesh).high_mm) << "nothing else moves";
    }
    options.hub.lock = HubLock::kDFlat;  // the flat's distance from the axis: bore radius less depth
    const auto flat = with_wider_bore(*build_part(test::disc(), options), 0.2e-3);
    EXPECT_NEAR(0.5 * (flat->options.hub.bore_diameter + flat->options.hub.bore_clearance) - flat->options.hub.flat_depth,
                0.5 * (options.hub.bore_diameter + options.hub.bore_clearance) - options.hub.flat_depth + 0.1e-3, 1e-15);
}

TEST(Compensation, ABoreThatHasNoRoomIsRefused) {
    PartOptions options = test::plain();
    options.hub.bore_diameter = 21e-3;  // in a floor of 11.6 mm radius
    options.chordal_error = 20e-6;
    const auto part = build_part(test::disc(), options);
    ASSERT_TRUE(part);
    const auto wider = with_wider_bore(*part, 2e-3);
    ASSERT_FALSE(wider);
    EXPECT_EQ(wider.refusal().front().rule, "solid.bore");
}

}  // namespace
}  // namespace fusee::solid
