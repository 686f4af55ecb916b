#include "isometric.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fusee::drawing {
namespace {

/// A box with its triangles counter-clockwise seen from outside.
void add_box(solid::Mesh& mesh, const solid::Vec3& low, const solid::Vec3& high) {
    const auto first = static_cast<std::uint32_t>(mesh.points_mm.size());
    for (int i = 0; i < 8; ++i) mesh.points_mm.push_back({i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 4 ? high[2] : low[2]});
    constexpr std::uint32_t kFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& f : kFaces) {
        mesh.triangles.push_back({first + f[0], first + f[1], first + f[2]});
        mesh.triangles.push_back({first + f[0], first + f[2], first + f[3]});
    }
}

double length_of(const std::vector<Line>& lines) {
    double length = 0.0;
    for (const Line& line : lines)
        for (std::size_t i = 1; i < line.size(); ++i) length += std::hypot(line[i][0] - line[i - 1][0], line[i][1] - line[i - 1][1]);
    return length;
}

/// Nine of a cube's twelve edges are seen, each sqrt(2/3) of its length; the diagonals of its faces are no edges.
TEST(Isometric, OfACubeHasNineEdges) {
    for (const bool from_below : {false, true}) {
        solid::Mesh cube;
        add_box(cube, {0.0, 0.0, 0.0}, {10.0, 10.0, 10.0});
        EXPECT_NEAR(length_of(isometric(cube, from_below)), 9.0 * 10.0 * std::sqrt(2.0 / 3.0), 0.5);
    }
}

/// A cube behind another along the line of sight adds nothing; one beside it adds as much.
TEST(Isometric, HidesWhatIsBehind) {
    solid::Mesh two;
    add_box(two, {0.0, 0.0, 0.0}, {10.0, 10.0, 10.0});
    add_box(two, {-19.0, 21.0, -19.0}, {-11.0, 29.0, -11.0});  // smaller, its middle moved by (-20, 20, -20)
    EXPECT_NEAR(length_of(isometric(two, false)), 9.0 * 10.0 * std::sqrt(2.0 / 3.0), 1.0);
    solid::Mesh apart;
    add_box(apart, {0.0, 0.0, 0.0}, {10.0, 10.0, 10.0});
    add_box(apart, {40.0, 40.0, 0.0}, {50.0, 50.0, 10.0});
    EXPECT_NEAR(length_of(isometric(apart, false)), 18.0 * 10.0 * std::sqrt(2.0 / 3.0), 1.0);
}

}  // namespace
}  // namespace fusee::drawing
