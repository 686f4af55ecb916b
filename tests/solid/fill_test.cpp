#include <gtest/gtest.h>

#include "fusee/solid/mesh.h"
#include "fusee/solid/outline.h"
#include "fusee/solid/validity.h"

namespace fusee::solid {
namespace {

const Ring kSquare{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, kHole{{1, 1}, {2, 1}, {2, 2}, {1, 2}};

double area_up(const Mesh& mesh) {
    double area = 0.0;
    for (const Triangle& t : mesh.triangles) {
        const Vec3 &a = mesh.points_mm[t[0]], &b = mesh.points_mm[t[1]], &c = mesh.points_mm[t[2]];
        area += 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
    }
    return area;
}

TEST(Fill, CoversTheFaceButNotItsHole) {
    Mesh up, down;
    fill_face(up, add_ring(up, kSquare, 1.0), {add_ring(up, kHole, 1.0)}, true);
    fill_face(down, add_ring(down, kSquare, 1.0), {add_ring(down, kHole, 1.0)}, false);
    EXPECT_DOUBLE_EQ(area_up(up), 15.0);
    EXPECT_DOUBLE_EQ(area_up(down), -15.0);
    EXPECT_EQ(up.points_mm.size(), 8u);  // none added
}

TEST(Fill, PrismIsASolidOfKnownVolume) {
    const Mesh box = prism(kSquare, -1.0, 2.0);
    EXPECT_DOUBLE_EQ(volume_mm3(box), 48.0);
    EXPECT_TRUE(validate(box).good()) << validate(box).line();
    const Quality q = measure_quality(box);
    EXPECT_EQ(q.boundary_edges, 0u);
    EXPECT_EQ(q.euler, 2);
    EXPECT_DOUBLE_EQ(q.shortest_edge_mm, 3.0);
    EXPECT_NEAR(q.smallest_angle_deg, 36.8699, 1e-3);  // atan(3/4)
    Mesh open = box;
    open.triangles.pop_back();
    EXPECT_EQ(measure_quality(open).boundary_edges, 3u);
    EXPECT_EQ(measure_quality(open).euler, 1);
}

TEST(FillFace, RingsThatCrossAreNotFilled) {
    Mesh mesh;
    const VertexRing bow = add_ring(mesh, {{0.0, 0.0}, {2.0, 2.0}, {2.0, 0.0}, {0.0, 2.0}}, 0.0);
    EXPECT_FALSE(fill_face(mesh, bow, {}, true));
    EXPECT_TRUE(mesh.triangles.empty());
}

TEST(Validity, SeesWhatIsWrong) {
    Mesh open = prism(kSquare, 0.0, 1.0);
    open.triangles.pop_back();
    EXPECT_FALSE(validate(open).closed);
    Mesh inside_out = prism(kSquare, 0.0, 1.0);
    for (Triangle& t : inside_out.triangles) std::swap(t[0], t[1]);
    EXPECT_TRUE(validate(inside_out).closed);
    EXPECT_FALSE(validate(inside_out).outward);
    Mesh two = prism(kSquare, 0.0, 1.0);
    const Mesh other = prism(kSquare, 0.5, 1.5);  // overlaps the first
    const auto base = static_cast<std::uint32_t>(two.points_mm.size());
    two.points_mm.insert(two.points_mm.end(), other.points_mm.begin(), other.points_mm.end());
    for (const Triangle& t : other.triangles) two.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
    EXPECT_EQ(validate(two).components, 2u);
    EXPECT_TRUE(validate(two).self_intersecting);
    EXPECT_FALSE(validate(two).good());
    ASSERT_TRUE(validate(two).meeting_mm);
    EXPECT_EQ((*validate(two).meeting_mm)[2], 0.0);  // of the first triangle that meets another: the lower prism's
    EXPECT_FALSE(validate(other).meeting_mm);
}

}  // namespace
}  // namespace fusee::solid
