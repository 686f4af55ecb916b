#include "fusee/cam/mirror.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fixture.h"
#include "fusee/core/units.h"
#include "fusee/solid/cutters.h"
#include "fusee/solid/outline.h"
#include "fusee/solid/part.h"
#include "fusee/solid/validity.h"

namespace fusee::solid {
namespace {

using namespace test;

/// A disc about a point off the axis, in a direction that is not its own image: h = R + e cos(psi - 0.8).
cam::Cam oblique() {
    cam::Cam cam = disc(0.012, 0.003);
    cam.path = [](double psi) {
        return cam::PathPoint{psi, 0.012 + 0.003 * std::cos(psi - 0.8), -0.003 * std::sin(psi - 0.8), 0.012, 0.0};
    };
    return cam;
}

/// Every feature that is not its own image, and those that are.
PartOptions featured() {
    PartOptions o;
    o.chordal_error = 10e-6;
    o.features.leg_slot_width = 1.2e-3;
    o.features.leg_slot_length = 2e-3;
    o.features.leg_slot_radius = 7e-3;
    o.features.leg_slot_depth = 1e-3;
    o.features.leg_slot_angle = 2.0;
    return o;
}

PartOptions coarse() {
    PartOptions o = plain();
    o.chordal_error = 20e-6;
    return o;
}

TEST(MirroredMesh, IsReflectedAndFacesOutward) {
    const Mesh mesh = build_part(oblique(), coarse()).value().mesh, other = mirrored(mesh);
    EXPECT_DOUBLE_EQ(volume_mm3(other), volume_mm3(mesh));
    EXPECT_TRUE(validate(other).good());
    for (std::size_t i = 0; i < mesh.points_mm.size(); i += 97)
        EXPECT_EQ(other.points_mm[i], (Vec3{mesh.points_mm[i][0], -mesh.points_mm[i][1], mesh.points_mm[i][2]}));
    const Quality quality = measure_quality(mesh), reflected = measure_quality(other);  // the image is not measured again
    EXPECT_EQ(reflected.triangles, quality.triangles);
    EXPECT_EQ(reflected.vertices, quality.vertices);
    EXPECT_EQ(reflected.euler, quality.euler);
    EXPECT_EQ(reflected.boundary_edges, quality.boundary_edges);
    EXPECT_EQ(reflected.shortest_edge_mm, quality.shortest_edge_mm);
    EXPECT_NEAR(reflected.smallest_angle_deg, quality.smallest_angle_deg, 1e-12);
    EXPECT_EQ(mirrored(other).points_mm, mesh.points_mm);
    EXPECT_EQ(mirrored(other).triangles, mesh.triangles);
}

// Two ways to the same part: mirror the solid, or build the mirrored cam. They differ in columns and diagonals, so within the chordal
// error.
TEST(MirroredPart, IsThePartOfTheMirroredCam) {
    const cam::Cam spool = oblique();
    const Part part = build_part(spool, featured()).value(), image = mirrored(part);
    const Part built = build_part(cam::mirrored(spool), mirrored(featured())).value();
    const double area = 2.0 * core::kPi * 13.0 * 5.0;  // of the rim [mm^2], by which a chordal error counts
    EXPECT_NEAR(volume_mm3(image.mesh), volume_mm3(built.mesh), image.chordal_error_mm * area);
    const Box a = bounding_box(image.mesh), b = bounding_box(built.mesh);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(a.low_mm[i], b.low_mm[i], part.chordal_error_mm);
        EXPECT_NEAR(a.high_mm[i], b.high_mm[i], part.chordal_error_mm);
    }
    const auto cutters = make_cutters(image), expected = make_cutters(built);
    ASSERT_EQ(cutters.size(), 3u);
    for (std::size_t i = 0; i < cutters.size(); ++i) {
        EXPECT_EQ(cutters[i].name, expected[i].name);
        for (std::size_t k = 0; k < 2; ++k)
            EXPECT_NEAR(cutters[i].outline[0].centre_mm[k], expected[i].outline[0].centre_mm[k], 2.0 * part.chordal_error_mm);
    }
    EXPECT_NEAR(image.options.features.leg_slot_angle, -2.0, 1e-15);
}

TEST(MirroredPart, KeepsItsColumnsInOrderFromTheGroovesBegin) {
    for (const Part& part : {build_part(oblique(), coarse()).value(), build_part(snail(1.3, 4e-3, 1e-3), coarse()).value()}) {
        const Part image = mirrored(part);
        ASSERT_EQ(image.columns_psi.size(), part.columns_psi.size());
        EXPECT_TRUE(std::is_sorted(image.columns_psi.begin(), image.columns_psi.end()));
        EXPECT_GE(image.columns_psi.front(), image.cam.groove_psi.low - 1e-6);
        EXPECT_LT(image.columns_psi.back(), image.cam.groove_psi.low + 2.0 * core::kPi);
        // One of them stands at the groove's begin: where it is cut off, a column of the mesh stands there.
        EXPECT_NEAR(image.columns_psi.front(), image.cam.groove_psi.low, part.cam.closed() ? 0.2 : 1e-9);
    }
}

/// Distance of the nearest vertex from the floor's lowest point at one place of the path [mm].
double to_floor(const Mesh& mesh, const cam::PathPoint& p) {
    const Point2 floor = flange_point(p, -0.4, 0.0).point;  // half the cable of the fixture
    double nearest = 1e9;
    for (const Vec3& v : mesh.points_mm)
        nearest = std::min(nearest, std::hypot(v[0] - floor[0], v[1] - floor[1], v[2] - core::mm_from_m(p.z)));
    return nearest;
}

/// Of three turns and more, of either hand: the land between neighbours is pitch - groove.
class LongHelix : public ::testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Turns, LongHelix, ::testing::Values(0.6, 3.2, 4.5));

TEST_P(LongHelix, IsMadeOfEitherHand) {
    const cam::Cam right = snail(GetParam(), 4e-3, 0.4e-3), left = cam::mirrored(right);
    ASSERT_TRUE(cam::left_handed(left));
    const auto part = build_part(right, coarse()), other = build_part(left, coarse());
    ASSERT_TRUE(part) << core::to_line(part.refusal().front());
    ASSERT_TRUE(other) << core::to_line(other.refusal().front());
    EXPECT_DOUBLE_EQ(volume_mm3(other->mesh), volume_mm3(part->mesh));
    EXPECT_DOUBLE_EQ(other->z_low, part->z_low);
    EXPECT_TRUE(validate(other->mesh).good()) << validate(other->mesh).line();
    // At every column the groove's floor stands where the left-handed path says, and not where a right-handed one would put it.
    const double turns = left.groove_psi.width() / core::kTurn;
    EXPECT_NEAR(core::mm_from_m(left.path(left.groove_psi.low).z - left.path(left.groove_psi.high).z), 4.0 * turns, 1e-9);
    const double column = other->columns_psi[other->columns_psi.size() / 3];
    const cam::PathPoint p = left.path(column), wrong = right.path(column);
    EXPECT_LT(to_floor(other->mesh, p), 4e-6);  // single precision at 14 mm is 1e-6
    EXPECT_GT(to_floor(other->mesh, {p.psi, p.h, p.slope, p.rho, wrong.z}), 0.1);
}

TEST(LeftHand, IsRefusedAsItsImageIs) {
    const cam::Cam right = snail(2.2, 1.5e-3, 0.4e-3);  // no land between the turns
    const auto a = build_part(right, coarse()), b = build_part(cam::mirrored(right), coarse());
    ASSERT_FALSE(a);
    ASSERT_FALSE(b);
    EXPECT_EQ(b.refusal().front().rule, "solid.turns");
    EXPECT_NEAR(b.refusal().front().measured, a.refusal().front().measured, 1e-9);
}

}  // namespace
}  // namespace fusee::solid
