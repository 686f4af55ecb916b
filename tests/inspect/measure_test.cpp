#include <gtest/gtest.h>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/inspect/body.h"
#include "fusee/solid/mesh_faults.h"
#include "inspect/shapes.h"

// What walls, gaps, holes and pieces of a mesh measure: closed forms, and no change when it is turned or measured by more threads.
namespace fusee::inspect {
namespace {

double least_wall(const Body& body) {
    double least = INFINITY;
    for (const Sample& s : body.samples())
        if (s.wall_mm < least) least = s.wall_mm;
    return least;
}

/// Turned about two axes; float rounding is not part of it.
solid::Mesh turned(solid::Mesh mesh) {
    const double c = std::cos(0.7), s = std::sin(0.7), e = std::cos(1.9), f = std::sin(1.9);
    for (solid::Vec3& p : mesh.points_mm) {
        p = {c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]};
        p = {p[0], e * p[1] - f * p[2], f * p[1] + e * p[2]};
    }
    return mesh;
}

TEST(Walls, OfATubeAreWhatItsFacetsAreApart) {
    const Body tube(sunk(polygon(20, 48), polygon(17, 48), 30), 4000, 1);
    // The facets of both polygons are parallel; near their ends the ray meets the neighbour, which is no nearer.
    EXPECT_NEAR(least_wall(tube), 1.5 * std::cos(kPi / 48), 1e-3);
}

TEST(Walls, OfASharpCornerAreNone) {
    const Body cube(block(10, 10, 10), 4000, 1);
    EXPECT_NEAR(least_wall(cube), 10.0, 1e-6) << "the right angles at its edges are no walls";
}

TEST(Walls, ThatEndInAnEdgeAreFeathers) {
    const Body wedge(tower({{{{0, 0}, {20, 0}, {0, 8}}, 10.0}}), 4000, 1);
    const Body blunt(tower({{{{0, 0}, {15, 0}, {15, 2}, {0, 8}}, 10.0}}), 4000, 1);  // the same, cut off where it is 2 mm thick
    for (const Sample& s : wedge.samples()) EXPECT_FALSE(s.wall_mm < 2.0) << s.wall_mm;
    const double least = least_wall(blunt);
    // A ball between both faces cannot be thicker than the cut is wide, nor much thinner: the cut itself stops it.
    EXPECT_GT(least, 1.5);
    EXPECT_LT(least, 2.1);
}

TEST(Walls, DoNotChangeWithTheFrame) {
    const solid::Mesh mesh = sunk(rectangle(20, 20), rectangle(10, 17), 10, 3);
    EXPECT_NEAR(least_wall(Body(mesh, 4000, 1)), 1.5, 1e-6);
    EXPECT_NEAR(least_wall(Body(turned(mesh), 4000, 1)), 1.5, 1e-6);
}

/// A tube whose coordinates are rounded to single precision, as those of an STL: from an edge the ray may hit the neighbour at once.
TEST(Walls, OnAnEdgeAreNoFailure) {
    solid::Mesh mesh = turned(sunk(polygon(20, 200), polygon(17, 200), 30));
    for (solid::Vec3& p : mesh.points_mm)
        for (double& x : p) x = static_cast<float>(x);
    const Body tube(mesh, 100, 1);
    for (std::uint32_t t = 0; t < tube.mesh().triangles.size(); ++t)
        for (int i = 0; i < 3; ++i) {
            const solid::Triangle& c = tube.mesh().triangles[t];
            const solid::Vec3 &p = tube.mesh().points_mm[c[i]], &q = tube.mesh().points_mm[c[(i + 1) % 3]], &n = tube.normals()[t];
            const solid::Vec3 middle{0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.5 * (p[2] + q[2])};
            for (const double side : {-1.0, 1.0}) {
                const auto ball = ball_at(tube, t, middle, {side * n[0], side * n[1], side * n[2]}, -0.5);
                EXPECT_TRUE(!ball || ball->touching_mm > 0.0) << "triangle " << t;
            }
        }
}

/// Copies of one triangle once overflowed the stack: CGAL's tree of corners divided them without end.
TEST(Samples, OfManyCopiesOfOneTriangle) {
    solid::Mesh mesh;
    mesh.points_mm = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}};
    mesh.triangles.assign(40'000, {0, 1, 2});
    const Body body(mesh, 20, 1);
    EXPECT_EQ(body.samples_left_out(), 0u);
    EXPECT_NEAR(body.samples().front().at_mm[2], 0.0, 1e-12);
}

/// Long triangles across one another: each query visits a large share of them.
solid::Mesh bundle(int count) {
    solid::Mesh mesh;
    for (int i = 0; i < count; ++i) {
        const double a = kPi * i / count, z = 0.001 * i, x = 50 * std::cos(a), y = 50 * std::sin(a);
        const auto first = static_cast<std::uint32_t>(mesh.points_mm.size());
        mesh.points_mm.insert(mesh.points_mm.end(), {{x, y, z}, {-x, -y, -z}, {x, y + 1, z - 1}});
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

TEST(Samples, ThatWouldCostTooMuchAreLeftOutAndSaidSo) {
    const Body all(bundle(2000), 500, 1), some(bundle(2000), 500, 1, 5'000), same(bundle(2000), 500, 3, 5'000);
    EXPECT_EQ(all.samples_left_out(), 0u);
    EXPECT_GT(some.samples_left_out(), 100u);
    EXPECT_EQ(some.samples().size() + some.samples_left_out(), all.samples().size());
    ASSERT_EQ(some.samples().size(), same.samples().size()) << "for any number of threads";
    double whole = 0.0, kept = 0.0;
    for (const Sample& s : all.samples()) whole += s.share_mm2;
    for (std::size_t i = 0; i < some.samples().size(); ++i) {
        kept += some.samples()[i].share_mm2;
        EXPECT_EQ(some.samples()[i].triangle, same.samples()[i].triangle);
    }
    EXPECT_NEAR(kept / whole, 1.0, 0.2);  // the triangles have nearly the same area
    const auto severity = [](const Body& body) {
        for (const Marked& m : check({body, {}}, "bundle"))
            if (m.finding.rule == "mesh.samples") return m.finding.severity;
        return core::Severity::kError;
    };
    EXPECT_EQ(severity(all), core::Severity::kPass);
    EXPECT_EQ(severity(some), core::Severity::kNotJudged);
}

TEST(Crossings, MoreNearPairsThanAreLookedAtAreSaid) {
    const solid::Mesh mesh = bundle(300);
    const solid::Crossings all = solid::crossings(mesh, {}), none = solid::crossings(mesh, {}, 1000);
    EXPECT_TRUE(all.complete && all.manifold);
    EXPECT_GT(all.pairs.size(), 100u);
    EXPECT_FALSE(none.complete);
    EXPECT_TRUE(none.manifold && none.pairs.empty());
}

TEST(Samples, SharesAddUpToTheSurface) {
    const Body body(block(20, 30, 10), 4000, 1);
    double whole = 0.0;
    for (const Sample& s : body.samples()) whole += s.share_mm2;
    EXPECT_NEAR(whole, 2 * (600 + 200 + 300), 0.01 * 2200);  // one sample more or less in each triangle
    EXPECT_NEAR(static_cast<double>(body.samples().size()), 4000.0, 1.0);
}

TEST(Samples, AreTheSameForAnyNumberOfThreads) {
    const solid::Mesh mesh = sunk(rectangle(20, 20), rounded(10, 10, 1), 10, 3);
    const Body one(mesh, 4000, 1), three(mesh, 4000, 3);
    ASSERT_EQ(one.samples().size(), three.samples().size());
    const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
    for (std::size_t i = 0; i < one.samples().size(); ++i) {
        EXPECT_EQ(one.samples()[i].at_mm, three.samples()[i].at_mm);
        EXPECT_TRUE(same(one.samples()[i].wall_mm, three.samples()[i].wall_mm));
        EXPECT_TRUE(same(one.samples()[i].gap_mm, three.samples()[i].gap_mm));
    }
}

std::vector<Hollow> holes(const solid::Mesh& mesh) {
    std::vector<Hollow> found = find_hollows(Body(mesh, 10, 1));
    std::erase_if(found, [](const Hollow& h) { return !h.is_hole(); });
    return found;
}

TEST(Holes, AreFoundWhateverTheirFacets) {
    for (const int sides : {5, 6, 8, 24, 96}) {
        const auto found = holes(turned(sunk(rectangle(20, 20), polygon(4, sides), 10)));
        ASSERT_EQ(found.size(), 1u) << sides;
        EXPECT_NEAR(found[0].diameter_mm, 4.0, 1e-9);
        EXPECT_NEAR(found[0].length_mm, 10.0, 1e-9);
        EXPECT_TRUE(found[0].is_through());
        EXPECT_EQ(found[0].triangles.size(), 2u * static_cast<std::size_t>(sides));
    }
}

// Two slivers across the wall divide it into arcs of 180 deg. Neither is a hole; together they are one.
TEST(Holes, AreFoundAcrossSliversThatRoundingTurned) {
    Ring ring = polygon(4, 96);
    for (const std::size_t at : {48u, 0u}) ring.insert(ring.begin() + at + 1, {0.9999 * ring[at][0], 0.9999 * ring[at][1]});
    const auto found = holes(turned(sunk(rectangle(20, 20), ring, 10)));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].diameter_mm, 4.0, 1e-9);
    EXPECT_NEAR(found[0].covers, 2.0 * kPi, 0.1);
}

TEST(Holes, BlindOnesAreToldApart) {
    const auto found = holes(sunk(rectangle(20, 20), polygon(4, 24), 10, 3));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].length_mm, 7.0, 1e-9);
    EXPECT_FALSE(found[0].is_through());
}

TEST(Holes, ArePinsSlotsAndSquaresNot) {
    EXPECT_TRUE(holes(tower({{polygon(20, 24), 10.0}})).empty()) << "round outside";
    EXPECT_TRUE(holes(sunk(rectangle(20, 20), rectangle(4, 4), 10)).empty());
    Ring slot;  // 4 mm wide, 8 mm between the arcs' centres
    for (int i = 0; i <= 16; ++i) slot.push_back({4 + 2 * std::cos(kPi * (i - 8) / 16), 2 * std::sin(kPi * (i - 8) / 16)});
    for (int i = 0; i <= 16; ++i) slot.push_back({-4 - 2 * std::cos(kPi * (i - 8) / 16), -2 * std::sin(kPi * (i - 8) / 16)});
    EXPECT_TRUE(holes(sunk(rectangle(20, 20), slot, 10)).empty());
}

TEST(Pieces, ACavityIsNotInsideOut) {
    solid::Mesh mesh = block(30, 30, 30);
    add(mesh, reversed(block(10, 10, 10)), {0, 0, 10});
    add(mesh, reversed(block(10, 10, 10)), {40, 0, 0});
    const Body body(mesh, 10, 1);
    EXPECT_EQ(body.cavity(), (std::vector<bool>{false, true, false}));
    EXPECT_EQ(body.turned(), (std::vector<bool>{false, false, true}));
    EXPECT_NEAR(solid::volume_mm3(body.mesh()), 27000 - 1000 + 1000, 1e-6);
}

TEST(Body, RefusesWhatIsNoSurface) {
    solid::Mesh mesh = block(10, 10, 10);
    mesh.triangles[3][1] = 99;
    EXPECT_THROW(Body(mesh, 10, 1), core::InvalidInput);
    const solid::Mesh line{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}};
    EXPECT_THROW(Body(line, 10, 1), core::InvalidInput);
}

TEST(Docs, TheTableOfRulesHasEveryRule) {
    for (const Rule& rule : rules())
        EXPECT_NE(checks::reference(checks::infos_of(rules())).find(std::string("| `") + rule.id + "` |"), std::string::npos) << rule.id;
}

}  // namespace
}  // namespace fusee::inspect
