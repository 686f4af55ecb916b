#include <gtest/gtest.h>

#include <set>

#include "inspect/shapes.h"

// Files of several bodies: each is judged by itself and named; where they meet is told.
namespace fusee::inspect {
namespace {

using Kind = Contact::Kind;

File file_of(const solid::Mesh& mesh, const std::vector<Item>& items = {}) { return File(mesh, items, 20'000, 2); }

solid::Mesh two(const solid::Mesh& a, const solid::Mesh& b, const solid::Vec3& by) {
    solid::Mesh mesh = a;
    add(mesh, b, by);
    return mesh;
}

std::vector<std::size_t> triangles(const File& file) {
    std::vector<std::size_t> counts;
    for (const Piece& piece : file.pieces()) counts.push_back(piece.triangles.size());
    return counts;
}

core::Finding of_file(const File& file, const std::string& rule) {
    for (const Marked& m : check({file.pieces().front().body, {}, {}, &file}, "file"))
        if (m.finding.rule == rule) return m.finding;
    return {};
}

TEST(Files, OfOneBodyHaveOnePiece) {
    const File file = file_of(block(10, 10, 10));
    EXPECT_EQ(triangles(file), std::vector<std::size_t>{12});
    EXPECT_EQ(file.pieces().front().name, "");
    EXPECT_TRUE(file.contacts().empty());
}

TEST(Files, ACavityBelongsToItsBodyAndABodyInsideItDoesNot) {
    solid::Mesh mesh = block(10, 10, 10);
    add(mesh, block(30, 30, 30), {50, 0, 0});
    add(mesh, reversed(block(20, 20, 20)), {50, 0, 5});
    add(mesh, block(5, 5, 5), {50, 0, 10});
    const File file = file_of(mesh);
    EXPECT_EQ(triangles(file), (std::vector<std::size_t>{12, 24, 12}));
    EXPECT_EQ(file.pieces()[1].body.cavity(), (std::vector<bool>{false, true}));
    EXPECT_NEAR(solid::volume_mm3(file.pieces()[1].body.mesh()), 27000 - 8000, 1e-6);
    EXPECT_TRUE(file.contacts().empty()) << "a body in a cavity touches nothing";
    EXPECT_EQ(file.pieces()[2].name, "body 3");
    EXPECT_EQ(file.pieces()[2].triangles.front(), 36u);
}

TEST(Files, AnInsideOutBodyIsABody) {
    const File file = file_of(two(block(10, 10, 10), reversed(block(10, 10, 10)), {20, 0, 0}));
    EXPECT_EQ(triangles(file), (std::vector<std::size_t>{12, 12}));
    EXPECT_TRUE(file.pieces()[1].body.turned().front());
}

/// A plate of 2 mm and a block: alone neither has a rib. Of the block's 20 mm another body is no part.
TEST(Files, ARibIsNotMeasuredInAnotherBody) {
    const solid::Mesh mesh = two(block(40, 20, 2), block(20, 20, 20), {160, 0, 0});
    for (const core::Finding& f : findings_of(mesh, checks::ProcessKind::kFdm))
        EXPECT_TRUE(f.rule == "mesh.bodies" || !core::is_broken(f)) << core::to_line(f);
    const core::Finding bodies = of_file(file_of(mesh), "mesh.bodies");
    EXPECT_EQ(bodies.measured, 2.0);
    EXPECT_NE(bodies.what.find("body 2 of 20.00 x 20.00 x 20.00 mm"), std::string::npos) << bodies.what;
}

TEST(Files, FindingsNameTheBody) {
    std::set<std::string> where;
    for (const core::Finding& f : findings_of(two(block(20, 20, 10), block(20, 20, 0.5), {40, 0, 0}), checks::ProcessKind::kFdm))
        if (f.rule == "mesh.wall" && core::is_broken(f)) where.insert(f.where.substr(0, f.where.find(" at")));
    EXPECT_EQ(where, std::set<std::string>{"body 2"});
}

struct Pair {
    const char* name;
    solid::Mesh mesh;
    std::size_t contacts;
    Kind kind = Kind::kTouch;
    double area_mm2 = 0.0;
    std::size_t corners = 0;
};

TEST(Contacts, AreToldByTheirKind) {
    const solid::Mesh cube = block(10, 10, 10);
    const Pair pairs[] = {
        {"apart", two(cube, cube, {10.1, 0, 0}), 0},
        {"a small block stands on a plate", two(block(40, 40, 5), cube, {3, 2, 5}), 1, Kind::kTouch},
        {"face to face, corners in common", welded(two(cube, cube, {10, 0, 0})), 1, Kind::kShare, 0, 4},
        {"edge to edge", welded(two(cube, cube, {10, 10, 0})), 1, Kind::kShare, 0, 2},
        {"corner to corner", welded(two(cube, cube, {10, 10, 10})), 1, Kind::kShare, 0, 1},
        // The upper and lower faces and the sides of each lie on those of the other: its end and half of four sides are inside.
        {"half overlapped, flush", two(cube, cube, {5, 0, 0}), 1, Kind::kOverlap, 100 + 4 * 50},
        {"overlapped across", two(block(30, 10, 10), block(10, 30, 10), {0, 0, 5}), 1, Kind::kOverlap, 2 * 10 * 5 + 10 * 10},
        {"one inside the other", two(block(30, 30, 30), cube, {0, 0, 10}), 1, Kind::kOverlap, 600},
        {"twice the same", two(cube, cube, {0, 0, 0}), 1, Kind::kOverlap, 600},
        {"twice the same, corners in common", welded(two(cube, cube, {0, 0, 0})), 1, Kind::kOverlap, 600},
    };
    for (const Pair& pair : pairs) {
        const File file = file_of(pair.mesh);
        ASSERT_EQ(triangles(file), (std::vector<std::size_t>{12, 12})) << pair.name;
        ASSERT_EQ(file.contacts().size(), pair.contacts) << pair.name;
        const core::Finding f = of_file(file, "mesh.contact");
        for (const Contact& c : file.contacts()) {
            EXPECT_EQ(c.kind, pair.kind) << pair.name;
            EXPECT_EQ(c.corners, pair.corners) << pair.name;
            EXPECT_NEAR(c.area_mm2, pair.area_mm2, 0.05 * pair.area_mm2) << pair.name;
            EXPECT_NE(f.what.find(pair.kind == Kind::kOverlap ? "body 1 and body 2 overlap" : "body 1 and body 2 touch"), std::string::npos)
                << f.what;
        }
        EXPECT_EQ(f.severity, pair.contacts == 0          ? core::Severity::kPass
                              : pair.kind == Kind::kTouch ? core::Severity::kWarning
                                                          : core::Severity::kError)
            << pair.name;
        for (const Piece& piece : file.pieces()) {
            EXPECT_EQ(piece.body.topology().crowded_edges, 0u) << pair.name;
            EXPECT_TRUE(piece.body.crossings().manifold && piece.body.crossings().pairs.empty()) << pair.name;
        }
    }
}

TEST(Items, AreNamedAndHaveTheirBodies) {
    solid::Mesh mesh = two(block(10, 10, 10), block(10, 10, 10), {20, 0, 0});
    add(mesh, block(5, 5, 5), {40, 0, 0});
    add(mesh, block(5, 5, 5), {50, 0, 0});
    const File file = file_of(mesh, {{"cam", 12}, {"cam", 12}, {"", 24}});
    std::vector<std::string> names;
    for (const Piece& piece : file.pieces()) names.push_back(piece.name);
    EXPECT_EQ(names, (std::vector<std::string>{"cam (item 1)", "cam (item 2)", "item 3 body 1", "item 3 body 2"}));
    EXPECT_EQ(of_file(file, "mesh.bodies").measured, 2.0) << "the most in one item";
    EXPECT_EQ(of_file(file_of(mesh, {{"a", 12}, {"b", 12}, {"c", 12}, {"d", 12}}), "mesh.bodies").severity, core::Severity::kPass);
}

TEST(Items, OfTwoPlatesAreNoPartThatIsTooLarge) {
    solid::Mesh mesh;
    std::vector<Item> items;
    for (const double plate : {0.0, 400.0})
        for (const double x : {0.0, 60.0, 120.0}) {
            add(mesh, block(40, 150, 10), {plate + x, 0, 0});
            items.push_back({"bar", 12});
        }
    const File file = file_of(mesh, items);
    const core::Finding plates = of_file(file, "mesh.plate");
    EXPECT_EQ(plates.measured, 2.0) << plates.what;
    EXPECT_EQ(plates.severity, core::Severity::kWarning);
    for (const Piece& piece : file.pieces())
        for (const Marked& m : check({piece.body, {}}, piece.name)) EXPECT_FALSE(core::is_broken(m.finding)) << core::to_line(m.finding);
    items.resize(3);
    mesh.triangles.resize(36);
    EXPECT_EQ(of_file(file_of(mesh, items), "mesh.plate").severity, core::Severity::kPass);
}

TEST(Files, AreTheSameForAnyNumberOfThreads) {
    solid::Mesh mesh = two(sunk(rectangle(20, 20), polygon(6, 24), 10), block(10, 10, 10), {8, 0, 2});
    add(mesh, block(40, 20, 2), {60, 0, 0});
    const auto all = [&](unsigned jobs) {
        const File file(mesh, {}, 20'000, jobs);
        std::string text;
        for (const Marked& m : check({file.pieces().front().body, {}, {}, &file}, "file")) text += core::to_line(m.finding) + "\n";
        for (const Piece& piece : file.pieces())
            for (const Marked& m : check({piece.body, {}}, piece.name)) text += core::to_line(m.finding) + "\n";
        return text;
    };
    EXPECT_EQ(all(1), all(3));
}

}  // namespace
}  // namespace fusee::inspect
