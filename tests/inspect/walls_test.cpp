#include <gtest/gtest.h>

#include <functional>

#include "inspect/shapes.h"

// Walls, edges and ribs whose every measure is known by construction: a thin wall is found with its thickness, an edge is none.
namespace fusee::inspect {
namespace {

double thinnest(const solid::Mesh& mesh, std::size_t samples = 4000) {
    double least = INFINITY;
    const Body body(mesh, samples, 2);
    for (const Sample& s : body.samples())
        if (s.wall_mm < least) least = s.wall_mm;
    return least;
}

const core::Finding* finding(const core::Findings& all, const std::string& rule) {
    for (const core::Finding& f : all)
        if (f.rule == rule) return &f;
    return nullptr;
}

core::Findings fdm(const solid::Mesh& mesh) { return findings_of(mesh, checks::ProcessKind::kFdm); }

double radians(double deg) { return deg * kPi / 180.0; }

/// From the origin to x = `reach`, leaving at `slope` [rad]: along a circle of radius 1 / |bend| that turns up (bend > 0) or down, or
/// straight.
Ring flank(double slope, double bend, double reach) {
    Ring ring;
    constexpr int kFacets = 40;
    for (int i = 0; i <= kFacets; ++i) {
        const double x = reach * i / kFacets;
        double y = std::tan(slope) * x;
        if (bend != 0.0) {
            const double r = 1.0 / bend, cx = -r * std::sin(slope), cy = r * std::cos(slope);
            y = cy - std::copysign(std::sqrt(r * r - (x - cx) * (x - cx)), bend);
        }
        ring.push_back({x, y});
    }
    return ring;
}

/// An edge at the origin between two flanks, the upper and the lower one, in a block that is 15 mm high above and below.
solid::Mesh wedge(double angle, double bend_up, double bend_down) {
    const double reach = 2.0;
    Ring ring = flank(0.5 * angle, bend_up, reach);
    const Ring low = flank(-0.5 * angle, -bend_down, reach);
    ring.push_back({reach, 15}), ring.push_back({reach + 10, 15}), ring.push_back({reach + 10, -15}), ring.push_back({reach, -15});
    for (std::size_t i = low.size(); i-- > 1;) ring.push_back(low[i]);
    std::reverse(ring.begin(), ring.end());
    return tower({{ring, 20.0}});
}

TEST(Edges, AreNoWallsBetweenFlatAndCurvedFaces) {
    for (const double angle : {31, 45, 60, 64, 68, 80, 100})
        for (const auto& [up, down] : {std::pair{0.0, 0.0}, {0.1, 0.0}, {0.1, 0.1}, {-0.1, 0.0}, {-0.1, 0.1}, {-0.1, -0.1}}) {
            if (angle > 90 && up + down > 0.0) continue;  // a hollow flank would turn back
            const core::Findings found = fdm(wedge(radians(angle), up, down));
            const std::string which = std::to_string(angle) + " deg, " + std::to_string(up) + ", " + std::to_string(down);
            for (const char* rule : {"mesh.wall", "mesh.rib", "mesh.pin", "mesh.feather_edge"}) {
                const core::Finding* f = finding(found, rule);
                EXPECT_FALSE(f && core::is_broken(*f)) << which << ": " << core::to_line(*f);
            }
        }
}

TEST(Edges, SharpOnesAreJudgedByTheirAngle) {
    for (const double angle : {8, 15, 20, 25, 29})
        for (const double bend : {0.0, 0.05}) {
            const core::Findings found = fdm(wedge(radians(angle), bend, 0.0));
            const core::Finding *feather = finding(found, "mesh.feather_edge"), *wall = finding(found, "mesh.wall");
            ASSERT_NE(feather, nullptr) << angle;
            EXPECT_NEAR(feather->measured, angle, bend == 0.0 ? 1e-6 : 2.5) << angle << ' ' << bend;
            EXPECT_FALSE(wall && core::is_broken(*wall)) << angle << ' ' << bend << core::to_line(*wall);
        }
}

/// A quarter of a block whose corner is rounded with `radius`; a bore of 5 mm along the same edge breaks out of the rounding.
solid::Mesh broken_out(double radius, double bore, double at) {
    // From the block's centre the corner is at (10, 10), its rounding about (10 - radius, 10 - radius), the bore about (at, at).
    const double c = 10 - radius, r = 0.5 * bore;
    // On the diagonal both circles are symmetric: they meet where |p - c| = radius and |p - at| = r.
    const double d = std::sqrt(2.0) * (at - c), along = (radius * radius - r * r + d * d) / (2 * d),
                 across = std::sqrt(radius * radius - along * along);
    const double half_out = std::atan2(across, along), half_bore = std::atan2(across, along - d);
    Ring ring{{-10, -10}, {10, -10}};
    for (int i = 0; i <= 16; ++i) {
        const double a = (0.25 * kPi - half_out) * i / 16;
        ring.push_back({c + radius * std::cos(a), c + radius * std::sin(a)});
    }
    for (int i = 1; i < 48; ++i) {
        const double a = 0.25 * kPi - half_bore - (2 * kPi - 2 * half_bore) * i / 48;
        ring.push_back({at + r * std::cos(a), at + r * std::sin(a)});
    }
    for (int i = 0; i <= 16; ++i) {
        const double a = 0.25 * kPi + half_out + (0.25 * kPi - half_out) * i / 16;
        ring.push_back({c + radius * std::cos(a), c + radius * std::sin(a)});
    }
    ring.push_back({-10, 10});
    return tower({{ring, 20.0}});
}

TEST(Edges, OfABoreThatBreaksOutOfARoundingAreNone) {
    for (const double radius : {4.0, 6.0, 8.0})
        for (const double at : {5.5, 6.0, 6.5, 7.0}) {
            const double c = 10 - radius, deepest = std::sqrt(2.0) * (at - c) + 2.5;
            if (!(at > c) || deepest < radius + 0.2) continue;
            const solid::Mesh mesh = broken_out(radius, 5.0, at);
            const core::Findings found = fdm(mesh);
            const double wall = 10 - at - 2.5;  // between the bore and the flat sides, if the foot of the bore lies beside the rounding
            for (const char* rule : {"mesh.wall", "mesh.rib", "mesh.pin"}) {
                const core::Finding* f = finding(found, rule);
                EXPECT_FALSE(f && wall > 1.2 && core::is_broken(*f)) << radius << ' ' << at << ' ' << core::to_line(*f);
            }
        }
}

TEST(Walls, HaveTheirThickness) {
    for (const double t : {0.3, 0.8, 1.5, 2.0}) {
        const auto near = [t](const char* what, const solid::Mesh& mesh, double expected) {
            const core::Findings found = fdm(mesh);
            const core::Finding* f = finding(found, "mesh.wall");
            ASSERT_NE(f, nullptr) << what << ' ' << t;
            EXPECT_NEAR(f->measured, expected, 0.03) << what << ' ' << t << core::to_line(*f);
        };
        near("plate", block(20, 30, t), t);
        near("tube", sunk(polygon(20, 96), polygon(20 - 2 * t, 96), 30), t);
        near("tube with other facets", sunk(polygon(20, 96), polygon(20 - 2 * t, 60), 30), t - 10 * (1 - std::cos(kPi / 96)));
        near("cup", sunk(rectangle(20, 20), rectangle(20 - 2 * t, 20 - 2 * t), 15, 5), t);
        for (const double taper : {2.0, 12.0, 28.0}) {  // 12 mm high, thinnest at its flat top
            const double w = t + 2 * 12 * std::tan(0.5 * radians(taper));
            solid::Mesh mesh = tower({{{{-0.5 * w, 0}, {0.5 * w, 0}, {0.5 * t, 12}, {-0.5 * t, 12}}, 20.0}});
            near("tapered", mesh, t);
        }
        Ring arc;  // a quarter of a tube
        for (int i = 0; i <= 32; ++i) arc.push_back({10 * std::cos(0.5 * kPi * i / 32), 10 * std::sin(0.5 * kPi * i / 32)});
        for (int i = 32; i >= 0; --i) arc.push_back({(10 - t) * std::cos(0.5 * kPi * i / 32), (10 - t) * std::sin(0.5 * kPi * i / 32)});
        near("arc", tower({{arc, 20.0}}), t);
        // Between two bores: thinnest on one line only.
        solid::Mesh web;
        const Ring outer = rectangle(30, 20);
        Ring left = polygon(6, 64), right = left;
        for (auto& p : left) p[0] -= 3 + 0.5 * t;
        for (auto& p : right) p[0] += 3 + 0.5 * t;
        const solid::VertexRing low = add_ring(web, outer, 0), high = add_ring(web, outer, 10);
        add_wall_between(web, low, high, true);
        const solid::VertexRing l0 = add_ring(web, left, 0), l1 = add_ring(web, left, 10), r0 = add_ring(web, right, 0),
                                r1 = add_ring(web, right, 10);
        add_wall_between(web, l0, l1, false), add_wall_between(web, r0, r1, false);
        fill_face(web, low, {l0, r0}, false), fill_face(web, high, {l1, r1}, true);
        near("web", web, t);
    }
}

/// A wall whose end is round or cut off obliquely is a wall up to its end.
TEST(Walls, EndRoundOrOblique) {
    for (const double t : {0.4, 0.6}) {
        Ring round{{-10, -0.5 * t}};
        for (int i = 0; i <= 16; ++i) round.push_back({0.5 * t * std::cos(kPi * (i - 8) / 16), 0.5 * t * std::sin(kPi * (i - 8) / 16)});
        round.push_back({-10, 0.5 * t});
        EXPECT_NEAR(thinnest(tower({{round, 20.0}})), t, 0.03);
        const Ring oblique{{-10, -0.5 * t}, {0, -0.5 * t}, {-t, 0.5 * t}, {-10, 0.5 * t}};
        EXPECT_NEAR(thinnest(tower({{oblique, 20.0}})), t, 0.03);
    }
}

TEST(Ribs, HaveTheirHeightAndThickness) {
    for (const auto& [t, height] : {std::pair{0.5, 3.0}, {0.8, 10.0}, {1.0, 15.0}, {1.5, 20.0}, {2.0, 30.0}}) {
        const core::Findings found = fdm(tower({{rectangle(30, 20), 6.0}, {rectangle(t, 18), 6.0 + height}}));
        const core::Finding* rib = finding(found, "mesh.rib");
        ASSERT_NE(rib, nullptr);
        EXPECT_NEAR(rib->measured, height / t, 0.7 / t) << t << ' ' << height << core::to_line(*rib);
        EXPECT_EQ(core::is_broken(*rib), height / t > 10.0);
        EXPECT_NEAR(finding(found, "mesh.wall")->measured, t, 0.03);
    }
}

TEST(Ribs, AreNoneOnAPlateThatIsThinEverywhere) {
    const core::Findings found = fdm(block(60, 40, 1.6));
    const core::Finding* rib = finding(found, "mesh.rib");
    EXPECT_FALSE(rib && core::is_broken(*rib)) << core::to_line(*rib);
}

}  // namespace
}  // namespace fusee::inspect
