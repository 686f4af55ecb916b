#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "fusee/solid/mesh.h"
#include "fusee/solid/mesh_faults.h"

// Triangles without area, and surfaces that touch themselves.
namespace fusee::solid {
namespace {

/// A block with a corner point on the middle of one upper edge: in the upper face a triangle lies along that edge.
Mesh block_with_a_flat_triangle() {
    Mesh mesh = prism({{0, 0}, {10, 0}, {10, 10}, {5, 10}, {0, 10}}, 0.0, 10.0);
    const auto flat = [&mesh](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        return flat_triangles({mesh.points_mm, {{a, b, c}}}).size() == 1;
    };
    std::vector<std::uint32_t> upper;
    std::erase_if(mesh.triangles, [&](const Triangle& t) {
        return mesh.points_mm[t[0]][2] == 10.0 && mesh.points_mm[t[1]][2] == 10.0 && mesh.points_mm[t[2]][2] == 10.0;
    });
    for (const auto& [x, y] : {std::pair{0, 0}, {10, 0}, {10, 10}, {5, 10}, {0, 10}})
        upper.push_back(static_cast<std::uint32_t>(
            std::find(mesh.points_mm.begin(), mesh.points_mm.end(), Vec3{double(x), double(y), 10.0}) - mesh.points_mm.begin()));
    mesh.triangles.push_back({upper[0], upper[1], upper[2]});
    mesh.triangles.push_back({upper[0], upper[2], upper[4]});
    mesh.triangles.push_back({upper[2], upper[3], upper[4]});
    EXPECT_TRUE(flat(upper[2], upper[3], upper[4]));
    return mesh;
}

TEST(Flat, ATriangleAlongAnEdgeIsFlipped) {
    const Mesh mesh = block_with_a_flat_triangle();
    ASSERT_TRUE(is_closed_and_oriented(mesh.triangles));
    ASSERT_EQ(flat_triangles(mesh).size(), 1u);
    const Mesh whole = without_flat_triangles(mesh);
    EXPECT_TRUE(is_closed_and_oriented(whole.triangles));
    EXPECT_TRUE(flat_triangles(whole).empty());
    EXPECT_NEAR(volume_mm3(whole), 1000.0, 1e-9);
}

TEST(Flat, ATriangleWithTwoCornersAtOnePlaceIsCollapsed) {
    Mesh mesh = prism({{0, 0}, {10, 0}, {10, 10}, {10, 10 + 1e-12}, {0, 10}}, 0.0, 10.0);
    ASSERT_FALSE(flat_triangles(mesh).empty());
    mesh = without_flat_triangles(std::move(mesh));
    EXPECT_TRUE(is_closed_and_oriented(mesh.triangles));
    EXPECT_TRUE(flat_triangles(mesh).empty());
    EXPECT_NEAR(volume_mm3(mesh), 1000.0, 1e-6);
}

/// Two blocks that share the points of one edge, or of one corner.
Mesh blocks_that_touch(double z) {
    Mesh mesh = prism({{0, 0}, {10, 0}, {10, 10}, {0, 10}}, 0.0, 10.0);
    const Mesh other = prism({{10, 10}, {20, 10}, {20, 20}, {10, 20}}, z, z + 10.0);
    std::vector<std::uint32_t> number;
    for (const Vec3& p : other.points_mm) {
        const auto found = std::find(mesh.points_mm.begin(), mesh.points_mm.end(), p);
        number.push_back(static_cast<std::uint32_t>(found - mesh.points_mm.begin()));
        if (found == mesh.points_mm.end()) mesh.points_mm.push_back(p);
    }
    for (const Triangle& t : other.triangles) mesh.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
    return mesh;
}

TEST(Parted, BlocksThatTouchInAnEdgeAreTwo) {
    const Mesh mesh = blocks_that_touch(0.0);
    EXPECT_EQ(mesh.points_mm.size(), 14u);
    EXPECT_FALSE(is_closed_and_oriented(mesh.triangles));
    const Mesh two = parted(mesh);
    EXPECT_TRUE(is_closed_and_oriented(two.triangles));
    EXPECT_EQ(two.points_mm.size(), 18u) << "each has the ends of the edge and its middle";
    EXPECT_NEAR(volume_mm3(two), 2000.0, 1e-9);
}

TEST(Parted, BlocksThatTouchInACornerAreTwo) {
    const Mesh mesh = blocks_that_touch(10.0);
    EXPECT_EQ(mesh.points_mm.size(), 15u);
    EXPECT_EQ(parted(mesh).points_mm.size(), 16u);
}

TEST(Parted, ASoundMeshStaysAsItIs) {
    const Mesh mesh = prism({{0, 0}, {10, 0}, {10, 10}, {0, 10}}, 0.0, 10.0), same = parted(mesh);
    EXPECT_EQ(same.points_mm.size(), mesh.points_mm.size());
    EXPECT_EQ(same.triangles.size(), mesh.triangles.size());
}

}  // namespace
}  // namespace fusee::solid
