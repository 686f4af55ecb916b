#include <gtest/gtest.h>

#include "brep/kernel/measure.h"
#include "fusee/core/units.h"
#include "fusee/exchange/brep.h"

namespace fusee::exchange::brep {
namespace {

using core::kPi, solid::Extrusion;

/// @param x_mm, z_mm of the middle of its lower face
Extrusion disc(double radius_mm, double length_mm, double x_mm, double z_mm, std::vector<solid::RoundHole> holes = {}) {
    Extrusion shape;
    shape.frame.translation() = Eigen::Vector3d(x_mm, 0.0, z_mm);
    shape.radius_mm = radius_mm, shape.length_mm = length_mm, shape.holes = std::move(holes);
    return shape;
}

Extrusion plate(double half_x_mm, double half_y_mm, double length_mm, double z_mm) {
    Extrusion shape = disc(0.0, length_mm, 0.0, z_mm);
    shape.half_x_mm = half_x_mm, shape.half_y_mm = half_y_mm;
    return shape;
}

Brep made(const std::vector<Extrusion>& shapes) {
    const auto body = extruded(shapes);
    if (!body) throw std::runtime_error(core::to_line(body.refusal().front()));
    return *body;
}

TEST(Extruded, APlateWithTwoHolesHasEightFaces) {
    Extrusion shape = plate(10.0, 5.0, 2.0, 1.0);
    shape.holes = {{-4.0, 0.0, 2.0}, {4.0, 1.0, 1.0}};
    const Brep body = made({shape});
    EXPECT_EQ(body.faces, 8U);
    EXPECT_EQ(count_solids(*body.shape), 1U);
    EXPECT_NEAR(body.volume_mm3, 2.0 * (200.0 - 5.0 * kPi), 1e-6);
    const solid::Box box = bounding_box(*body.shape);
    for (const auto& [found, wanted] :
         {std::pair{box.low_mm[0], -10.0}, {box.high_mm[1], 5.0}, {box.low_mm[2], 1.0}, {box.high_mm[2], 3.0}})
        EXPECT_NEAR(found, wanted, 1e-6);
}

// The frame's x, y and z along the body's y, z and x.
TEST(Extruded, AFrameTurnsTheShape) {
    Extrusion shape = plate(3.0, 2.0, 8.0, 0.0);
    shape.frame.linear() << 0, 0, 1, 1, 0, 0, 0, 1, 0;
    const solid::Box box = bounding_box(*made({shape}).shape);
    const solid::Vec3 low{0.0, -3.0, -2.0}, high{8.0, 3.0, 2.0};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(box.low_mm[i], low[i], 1e-6);
        EXPECT_NEAR(box.high_mm[i], high[i], 1e-6);
    }
}

// Two flanges on a floor with a common bore: two ends, two rims, two shoulders, the floor and one bore.
TEST(Extruded, ADrumIsOneSolidWithOneBore) {
    const std::vector<solid::RoundHole> bore{{0.0, 0.0, 2.0}};
    const Brep body = made({disc(8.0, 4.0, 0.0, -2.0, bore), disc(10.0, 1.0, 0.0, -3.0, bore), disc(10.0, 1.0, 0.0, 2.0, bore)});
    EXPECT_EQ(count_solids(*body.shape), 1U);
    EXPECT_EQ(body.faces, 8U);
    EXPECT_NEAR(body.volume_mm3, kPi * (64.0 * 4.0 + 200.0 - 4.0 * 6.0), 1e-6);
}

TEST(Extruded, RodsThatDoNotTouchStayTwoSolids) {
    const Brep body = made({disc(3.0, 50.0, 0.0, 0.0), disc(3.0, 50.0, 20.0, 0.0)});
    EXPECT_EQ(count_solids(*body.shape), 2U);
    EXPECT_NEAR(body.volume_mm3, 2.0 * 9.0 * kPi * 50.0, 1e-6);
}

// A bush under a plate: the cylinder meets the plane in one line, which no solid can have inside.
TEST(Extruded, ARodThatMeetsAPlateInALineStaysASolid) {
    Extrusion rod = disc(3.0, 10.0, 0.0, 0.0);
    rod.frame =
        Eigen::Translation3d(-5.0, 0.0, -3.0) * Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX());
    const Brep body = made({plate(10.0, 10.0, 2.0, 0.0), rod});
    EXPECT_EQ(count_solids(*body.shape), 2U);
    EXPECT_NEAR(body.volume_mm3, 800.0 + 90.0 * kPi, 1e-6);
}

TEST(Extruded, RefusesShapesThatOverlap) {
    const auto body = extruded(std::vector{disc(3.0, 10.0, 0.0, 0.0), disc(3.0, 10.0, 0.0, 9.0)});
    ASSERT_FALSE(body);
    EXPECT_EQ(body.refusal().front().rule, "brep.validity");
    EXPECT_NEAR(body.refusal().front().measured, 9.0 * kPi * 19.0, 1e-6);
}

// Known answer: two cylinders of radius r, their axes at right angles and crossing, have 16 r^3 / 3 in common (Steinmetz).
TEST(CommonVolume, OfCrossingAndOfTouchingBodies) {
    Extrusion across = disc(2.0, 10.0, 0.0, 0.0);
    across.frame =
        Eigen::Translation3d(-5.0, 0.0, 5.0) * Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX());
    const Brep upright = made({disc(2.0, 10.0, 0.0, 0.0)});
    EXPECT_NEAR(common_volume_mm3(*upright.shape, *made({across}).shape), 16.0 / 3.0 * 8.0, 1e-2);
    const Brep ring = made({disc(5.0, 4.0, 0.0, 2.0, {{0.0, 0.0, 2.0}})});
    EXPECT_NEAR(common_volume_mm3(*upright.shape, *ring.shape), 0.0, 1e-9);
}

}  // namespace
}  // namespace fusee::exchange::brep
