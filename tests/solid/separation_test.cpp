#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "fixture.h"
#include "fusee/solid/mesh.h"
#include "fusee/solid/mesh_faults.h"
#include "fusee/solid/validity.h"

namespace fusee::solid {
namespace {

using namespace test;

/// Small whole numbers: exact in doubles, and full of points in one line or plane.
class Grid {
public:
    [[nodiscard]] Vec3 point() { return {number(), number(), number()}; }
    /// A corner that puts the point p inside the triangle: p = (2 a + b + c)/4.
    [[nodiscard]] static Vec3 third(const Vec3& p, const Vec3& a, const Vec3& b) {
        return {4 * p[0] - 2 * a[0] - b[0], 4 * p[1] - 2 * a[1] - b[1], 4 * p[2] - 2 * a[2] - b[2]};
    }

private:
    double number() { return number_(random_); }
    std::mt19937 random_{7};
    std::uniform_int_distribution<int> number_{-2, 2};
};

// Triangles that meet by construction are never "proven" apart: also not where they lie in one plane or have no area.
TEST(SurelyApart, IsNeverSaidOfTrianglesThatMeet) {
    Grid grid;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 p = grid.point(), a = grid.point(), b = grid.point(), c = grid.point(), d = grid.point();
        const Mesh mesh{{a, b, Grid::third(p, a, b), c, d, Grid::third(p, c, d)}, {}};
        EXPECT_FALSE(surely_apart(mesh, {0, 1, 2}, {3, 4, 5})) << i;
        EXPECT_FALSE(surely_apart(mesh, {0, 1, 2}, {5, 4, 3})) << i;
    }
}

// With a common corner they meet in one more point.
TEST(SurelyApart, IsNeverSaidOfTrianglesThatMeetBesideTheirCommonCorner) {
    Grid grid;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 corner = grid.point(), p = grid.point(), a = grid.point(), b = grid.point();
        if (p == corner) continue;
        const Mesh mesh{{corner, a, Grid::third(p, a, corner), b, Grid::third(p, b, corner)}, {}};
        EXPECT_FALSE(surely_apart(mesh, {0, 1, 2}, {0, 3, 4})) << i;
        EXPECT_FALSE(surely_apart(mesh, {1, 2, 0}, {4, 0, 3})) << i;
    }
}

TEST(SurelyApart, IsNeverSaidOfAFold) {
    const Mesh mesh{{{0, 0, 0}, {4, 0, 0}, {1, 3, 0}, {2, 1, 0}, {2, -1, 0}, {2, 0, 1}}, {}};
    EXPECT_FALSE(surely_apart(mesh, {0, 1, 2}, {1, 0, 3})) << "folded onto it";
    EXPECT_FALSE(surely_apart(mesh, {0, 1, 2}, {0, 1, 4})) << "the common side runs the same way";
    EXPECT_FALSE(surely_apart(mesh, {0, 1, 2}, {2, 1, 0})) << "the same triangle";
    for (const Triangle f : {Triangle{0, 1, 2}, Triangle{1, 2, 0}, Triangle{2, 0, 1}}) {
        EXPECT_TRUE(surely_apart(mesh, f, {1, 0, 4})) << "flat";
        EXPECT_TRUE(surely_apart(mesh, f, {5, 1, 0})) << "bent";
        EXPECT_TRUE(surely_apart(mesh, {0, 5, 1}, f)) << "bent";
    }
}

// What the proof is for: of a part nearly every pair of neighbours is decided by it; the flat faces too.
TEST(DoubtfulTriangles, AreFewInAPart) {
    PartOptions options;
    options.chordal_error = 10e-6;
    const Mesh mesh = build_part(disc(0.012, 0.003), options).value().mesh;
    const auto doubtful = doubtful_triangles(mesh);
    EXPECT_LT(doubtful.size(), mesh.triangles.size() / 50);
    EXPECT_TRUE(std::is_sorted(doubtful.begin(), doubtful.end()));
}

// A needle through the upper face of a slab, and a triangle without area: found, and the mesh is not valid.
TEST(DoubtfulTriangles, HoldAllThatMeet) {
    Mesh slab = prism({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, 0.0, 1.0);
    const auto first = static_cast<std::uint32_t>(slab.points_mm.size());
    slab.points_mm.insert(slab.points_mm.end(), {{2.5, 1.0, 0.5}, {2.6, 1.0, 2.0}, {2.5, 1.1, 2.0}});
    slab.triangles.push_back({first, first + 1, first + 2});
    const auto doubtful = doubtful_triangles(slab);
    EXPECT_EQ(doubtful.back(), slab.triangles.size() - 1);
    EXPECT_GE(doubtful.size(), 2u);
    EXPECT_TRUE(validate(slab).self_intersecting);
    slab.points_mm[first] = {2.5, 1.0, 5.0};  // clear of the slab, all in one line
    slab.points_mm[first + 1] = {2.75, 1.0, 6.5};
    slab.points_mm.back() = {2.625, 1.0, 5.75};
    EXPECT_EQ(doubtful_triangles(slab).back(), slab.triangles.size() - 1);
    EXPECT_TRUE(validate(slab).self_intersecting);
}

// The search for near pairs leaves none out: triangles of very different sizes, of which each two are also judged alone.
TEST(Crossings, AreThoseOfEachPairAlone) {
    std::mt19937 random{11};
    std::uniform_real_distribution<double> place{-5.0, 5.0}, size{-1.0, 1.0};
    Mesh mesh;
    for (std::uint32_t i = 0; i < 90; ++i) {
        const Vec3 middle{place(random), place(random), i % 3 == 0 ? 0.0 : place(random)};
        for (int k = 0; k < 3; ++k) {
            Vec3 p = middle;
            for (double& x : p) x += (i % 9 == 0 ? 8.0 : 1.0) * size(random);
            mesh.points_mm.push_back(p);
        }
        mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    std::vector<std::array<std::uint32_t, 2>> alone;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
        for (std::uint32_t k = i + 1; k < mesh.triangles.size(); ++k)
            if (!crossings({mesh.points_mm, {mesh.triangles[i], mesh.triangles[k]}}, {}).pairs.empty()) alone.push_back({i, k});
    EXPECT_GT(alone.size(), 30u);
    EXPECT_EQ(crossings(mesh, {}).pairs, alone);
}

}  // namespace
}  // namespace fusee::solid
