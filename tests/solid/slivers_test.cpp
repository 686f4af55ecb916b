#include <gtest/gtest.h>

#include "fusee/solid/mesh.h"
#include "fusee/solid/mesh_faults.h"
#include "fusee/solid/outline.h"
#include "fusee/solid/validity.h"

namespace fusee::solid {
namespace {

const Ring kSliverSquare{{0, 0}, {4, 0}, {4, 4}, {0, 4}};

// Known: a corner split by 5e-5 mm, top and bottom, is one corner again; 0.1 mm is a feature and stays.
TEST(Slivers, OfAnotherKernelCollapse) {
    const auto split = [](double by) { return prism({{0, 0}, {by, 0}, {4, 0}, {4, 4}, {0, 4}}, 0.0, 2.0); };
    const auto cured = without_slivers(split(5e-5));
    ASSERT_TRUE(cured);
    EXPECT_EQ(cured->points_mm.size(), 8u);
    EXPECT_TRUE(validate(*cured).good()) << validate(*cured).line();
    EXPECT_NEAR(volume_mm3(*cured), 32.0, 1e-3);
    EXPECT_EQ(without_slivers(split(0.1))->points_mm.size(), 10u);
    Mesh broken = split(0.1);
    broken.triangles.push_back(broken.triangles.front());
    EXPECT_FALSE(without_slivers(broken));
}

/// The mesh with a point half-way on the first edge of its first triangle, which that triangle alone is parted at: beside the edge as its
/// neighbour has it a triangle without an area is left, as rounding makes them.
Mesh with_cap(Mesh mesh) {
    const Triangle t = mesh.triangles.front();
    const Vec3 &a = mesh.points_mm[t[0]], &b = mesh.points_mm[t[1]];
    const auto middle = static_cast<std::uint32_t>(mesh.points_mm.size());
    mesh.points_mm.push_back({0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2])});
    mesh.triangles.front() = {t[0], middle, t[2]};
    mesh.triangles.push_back({middle, t[1], t[2]});
    mesh.triangles.push_back({t[0], t[1], middle});
    return mesh;
}

TEST(Slivers, TrianglesWithoutAnAreaAreFlippedAway) {
    const Mesh folded = with_cap(prism(kSliverSquare, 0.0, 2.0));
    EXPECT_FALSE(validate(folded).good());
    EXPECT_FALSE(validate(without_slivers(folded).value()).good()) << "none of its edges is short";
    const auto cured = without_folds(folded, 1e-3);
    ASSERT_TRUE(cured);
    EXPECT_TRUE(validate(*cured).good()) << validate(*cured).line();
    EXPECT_EQ(cured->points_mm.size(), 9u);
    EXPECT_DOUBLE_EQ(volume_mm3(*cured), 32.0);
}

TEST(Slivers, LongerOnesGoWithTheFoldsWhereAsked) {
    const Mesh split = prism({{0, 0}, {5e-4, 0}, {4, 0}, {4, 4}, {0, 4}}, 0.0, 2.0);
    EXPECT_EQ(without_slivers(split)->points_mm.size(), 10u);
    EXPECT_EQ(without_folds(split, 1e-3)->points_mm.size(), 8u);
    EXPECT_EQ(without_folds(split, 4e-4)->points_mm.size(), 10u);
}

}  // namespace
}  // namespace fusee::solid
