#include "fusee/drawing/inspection.h"

#include <gtest/gtest.h>

#include <cmath>

#include "exchange/fixtures/parts.h"

namespace fusee::drawing {
namespace {

constexpr double kTen = 10.0 * core::kPi / 180.0;

solid::Part bare(const cam::Cam& cam) {
    solid::Part part;
    part.cam = cam;
    part.options.features.anchor_hole_diameter = 0.0;
    return part;
}

TEST(InspectFloor, OfAnEccentricDiscIsItsPolarEquation) {
    // Pitch circle of 12 mm about (2, 0), cable of 1 mm: the floor is a circle of 11.5 mm, r = e cos a + sqrt(R^2 - e^2 sin^2 a).
    const auto floor = inspect_floor(bare(fixtures::planar_cam(12e-3, 2e-3)), kTen);
    ASSERT_EQ(floor.size(), 36u);
    for (std::size_t i = 0; i < floor.size(); ++i) {
        const double a = kTen * static_cast<double>(i);
        EXPECT_NEAR(floor[i].angle, a, 1e-12);
        EXPECT_NEAR(floor[i].radius, 2e-3 * std::cos(a) + std::sqrt(11.5e-3 * 11.5e-3 - std::pow(2e-3 * std::sin(a), 2)), 1e-15);
        EXPECT_EQ(floor[i].z, 0.0);
    }
}

TEST(InspectFloor, KnowsTheWorkingArcByItsNormals) {
    const cam::Cam cam = fixtures::planar_cam();  // working arc psi 0.5 to 3.0
    const core::Range arc = working_angles(cam);
    // The floor's point at psi: body angle psi + atan(h'/h) with h = 11.5 + 2 cos psi.
    EXPECT_NEAR(arc.low, 0.5 + std::atan2(-2.0 * std::sin(0.5), 11.5 + 2.0 * std::cos(0.5)), 1e-12);
    for (const FloorPoint& p : inspect_floor(bare(cam), kTen)) EXPECT_EQ(p.works, arc.holds(p.angle)) << p.angle;
}

TEST(WorkingAngles, OfAPlanarPartCountFromTheTurnOfTheTable) {
    cam::Cam cam = fixtures::planar_cam(12e-3, 0.0);  // round: the body angle is psi
    cam.working_psi = {-4.0, -1.0};
    const core::Range arc = working_angles(cam);
    EXPECT_NEAR(arc.low, 2.0 * core::kPi - 4.0, 1e-12);
    EXPECT_NEAR(arc.high, 2.0 * core::kPi - 1.0, 1e-12);
}

TEST(InspectFloor, OfAHelixClimbsAndCountsOnOverItsTurns) {
    const cam::Cam cam = fixtures::helix_cam(10e-3, 0.0, 6e-3);  // a round one: r is the floor's radius and the body angle psi itself
    const auto floor = inspect_floor(bare(cam), kTen);
    ASSERT_GT(floor.size(), 50u);  // 10.2 rad
    EXPECT_NEAR(floor.front().angle, -2.0 * kTen, 1e-12);
    for (const FloorPoint& p : floor) {
        EXPECT_NEAR(p.radius, 9.5e-3, 1e-15);
        EXPECT_NEAR(p.z, 6e-3 * p.angle / (2.0 * core::kPi), 1e-15);
    }
}

TEST(InspectFloor, SaysWhereTheAnchorHoleHasTakenTheFloor) {
    solid::Part part = bare(fixtures::planar_cam(12e-3, 0.0));
    part.section = solid::groove_section({}, 1e-3, 1e-5);
    part.options.features.anchor_hole_diameter = 3e-3;
    // The hole touches the pitch circle from inside at psi 3.6: centre at 10.5 mm, its rim crosses the floor (11.5 mm) where
    // cos(da) = (11.5^2 + 10.5^2 - 1.5^2)/(2 11.5 10.5), 0.102 rad or 5.8 degrees to both sides of 206.3.
    for (const FloorPoint& p : inspect_floor(part, kTen)) EXPECT_EQ(p.drilled, std::abs(p.angle - 3.6) < 0.102) << p.angle;
}

TEST(CableLength, OfADiscIsItsArc) {
    const CableLength length = cable_length(fixtures::planar_cam(12e-3, 2e-3));
    // Chords of 1/1000 turn, corrected to the fourth order: (2 pi/1000)^4/1920 = 1e-12 of the length is left.
    EXPECT_NEAR(length.working, 12e-3 * 2.5, 1e-13);
    EXPECT_NEAR(length.to_anchor, 12e-3 * (0.5 + 2.0 * core::kPi - 3.6), 1e-13);  // the tension winds towards lower psi
}

TEST(CableLength, OfAHelixCountsItsClimb) {
    const CableLength length = cable_length(fixtures::helix_cam(10e-3, 0.0, 6e-3));
    const double per_rad = std::hypot(10e-3, 6e-3 / (2.0 * core::kPi));
    EXPECT_NEAR(length.working, 9.4 * per_rad, 1e-12);
    EXPECT_NEAR(length.to_anchor, 0.2 * per_rad, 1e-12);
}

}  // namespace
}  // namespace fusee::drawing
