#include "fusee/exchange/mesh_file.h"

#include <fmt/format.h>

#include <cctype>
#include <cstring>

#include "exchange/fixtures/disc.h"
#include "exchange/fixtures/expect_refusal.h"
#include "exchange/fixtures/read_3mf.h"
#include "exchange/fixtures/zip.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/exchange/step.h"
#include "fusee/exchange/stl.h"
#include "fusee/exchange/three_mf.h"
#include "fusee/solid/mesh.h"
#include "fusee/solid/validity.h"
#include "solid/fixture.h"

// Third-party files: every format comes in as it is, and what is broken is named.
namespace fusee::exchange {
namespace {

class MeshFileTest : public fixtures::FolderTest {
protected:
    const solid::Mesh cube_ = solid::prism({{0, 0}, {10, 0}, {10, 10}, {0, 10}}, 0.0, 10.0);

    std::filesystem::path write(const std::string& name, const std::string& text) const {
        core::write_file(folder_ / name, text);
        return folder_ / name;
    }
    /// @param corners of each triangle, as "x y z"
    std::string text_stl(const solid::Mesh& mesh) const {
        std::string text = "solid foreign\n";
        for (const solid::Triangle& t : mesh.triangles) {
            text += "facet normal 0 0 0\nouter loop\n";
            for (const std::uint32_t p : t)
                text += fmt::format("vertex {} {} {}\n", mesh.points_mm[p][0], mesh.points_mm[p][1], mesh.points_mm[p][2]);
            text += "endloop\nendfacet\n";
        }
        return text + "endsolid foreign\n";
    }
    static void expect_cube(const MeshFile& file, double side = 10.0) {
        EXPECT_EQ(file.mesh.points_mm.size(), 8u);
        EXPECT_EQ(file.mesh.triangles.size(), 12u);
        EXPECT_NEAR(solid::volume_mm3(file.mesh), side * side * side, 1e-4 * side * side * side);
    }
};

TEST_F(MeshFileTest, ReadsStlOfBothKinds) {
    write_stl(folder_ / "a.STL", cube_, "foreign");
    expect_cube(read_mesh_file(folder_ / "a.STL"));
    expect_cube(read_mesh_file(write("b.stl", text_stl(cube_))));
}

/// Keywords in capitals, as some programs write them; a text that begins behind a byte order mark; a binary file whose header says "solid".
TEST_F(MeshFileTest, ReadsStlWithSolidInAnyPlaceAndCase) {
    std::string capitals = text_stl(cube_), mixed = capitals;
    for (char& c : capitals) c = static_cast<char>(std::toupper(c));
    for (const char* word : {"solid", "facet", "vertex", "loop"})
        for (std::size_t at = mixed.find(word); at != std::string::npos; at = mixed.find(word, at)) mixed[at] -= 'a' - 'A';
    expect_cube(read_mesh_file(write("capitals.stl", capitals)));
    expect_cube(read_mesh_file(write("mixed.stl", mixed)));
    expect_cube(read_mesh_file(write("mark.stl", "\xEF\xBB\xBF\r\n " + capitals)));
    write_stl(folder_ / "b.stl", cube_, "foreign");
    std::string binary = core::read_file(folder_ / "b.stl");
    for (const char* word : {"solid", "SOLID", "Solid"}) expect_cube(read_mesh_file(write("binary.stl", binary.replace(0, 5, word))));
    fixtures::expect_refusal([&] { (void)read_mesh_file(write("cut.stl", capitals.substr(0, capitals.size() / 2))); }, {"endsolid"});
}

TEST_F(MeshFileTest, ReadsObjWithFacesOfFourCorners) {
    const std::string obj =
        "o cube\nv 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nv 0 0 10\nv 10 0 10\nv 10 10 10\nv 0 10 10\n"
        "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    const MeshFile file = read_mesh_file(write("a.obj", obj));
    expect_cube(file);
    EXPECT_EQ(file.unit, "none, taken as millimetres");
}

TEST_F(MeshFileTest, ReadsEveryItemOf3mf) {
    solid::Mesh other = cube_;
    for (solid::Vec3& p : other.points_mm) p[0] += 20.0;
    write_3mf(folder_ / "a.3mf", {{"one", cube_}, {"two", other}}, "foreign");
    const MeshFile file = read_mesh_file(folder_ / "a.3mf");
    EXPECT_EQ(file.mesh.triangles.size(), 24u);
    EXPECT_NEAR(solid::volume_mm3(file.mesh), 2000.0, 1e-3);
    EXPECT_EQ(file.unit, "millimetre");
}

TEST_F(MeshFileTest, TessellatesStep) {
    const cam::Cam cam = solid::test::disc(12e-3, 3e-3, 0.8e-3);
    const brep::Brep brep = brep::build(solid::build_part(cam, solid::test::plain()).value()).value();
    write_step(folder_ / "a.stp", brep, "k_se", "foreign");
    const MeshFile file = read_mesh_file(folder_ / "a.stp");
    EXPECT_TRUE(solid::validate(file.mesh).good()) << solid::validate(file.mesh).line();
    // chords within 0.01 mm of a surface of about 1500 mm^2
    EXPECT_NEAR(solid::volume_mm3(file.mesh), brep.volume_mm3, 15.0);
    EXPECT_EQ(file.unit, "millimetre (STEP)");
}

/// A block of 1 x 2 x 3, turned by 90 deg about z, beside an item of two, of which one is mirrored.
TEST_F(MeshFileTest, ItemsOf3mfKeepTheirNamesAndPlaces) {
    std::string mesh = "<mesh><vertices>";
    for (int i = 0; i < 8; ++i) mesh += fmt::format("<vertex x=\"{}\" y=\"{}\" z=\"{}\"/>", i & 1, i & 2, (i & 4) * 0.75);
    mesh += "</vertices><triangles>";
    const int faces[12][3] = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                              {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    for (const auto& f : faces) mesh += fmt::format("<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>", f[0], f[1], f[2]);
    mesh += "</triangles></mesh>";
    const std::string model =
        "<model unit=\"centimeter\" xml:lang=\"en-US\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"><resources>"
        "<object id=\"1\" type=\"model\" name=\"block\">" +
        mesh +
        "</object><object id=\"2\" type=\"model\" name=\"pair\"><components>"
        "<component objectid=\"1\"/><component objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 10 0 0\"/></components></object></resources>"
        "<build><item objectid=\"1\" transform=\"0 1 0 -1 0 0 0 0 1 5 0 0\"/><item objectid=\"2\" transform=\"1 0 0 0 1 0 0 0 1 0 7 "
        "0\"/></build></model>";
    core::write_file(folder_ / "placed.3mf", fixtures::three_mf(model));
    const MeshFile file = read_mesh_file(folder_ / "placed.3mf");
    ASSERT_EQ(file.items.size(), 2u);
    EXPECT_EQ(file.items[0].name, "block");
    EXPECT_EQ(file.items[1].name, "pair");
    EXPECT_EQ(file.items[0].triangles, 12u);
    EXPECT_EQ(file.items[1].triangles, 24u);
    const auto box_of = [&](std::size_t first, std::size_t count) {
        solid::Mesh part{file.mesh.points_mm,
                         {file.mesh.triangles.begin() + static_cast<std::ptrdiff_t>(first),
                          file.mesh.triangles.begin() + static_cast<std::ptrdiff_t>(first + count)}};
        EXPECT_NEAR(solid::volume_mm3(part), 500.0 * static_cast<double>(count), 1e-3) << "outward, mirrored or not";
        solid::Box box{{1e9, 1e9, 1e9}, {-1e9, -1e9, -1e9}};
        for (const solid::Triangle& t : part.triangles)
            for (const std::uint32_t p : t)
                for (std::size_t i = 0; i < 3; ++i) {
                    box.low_mm[i] = std::min(box.low_mm[i], part.points_mm[p][i]);
                    box.high_mm[i] = std::max(box.high_mm[i], part.points_mm[p][i]);
                }
        return box;
    };
    EXPECT_EQ(box_of(0, 12).low_mm, (solid::Vec3{30, 0, 0})) << "x' = 5 - y, y' = x";
    EXPECT_EQ(box_of(0, 12).high_mm, (solid::Vec3{50, 10, 30}));
    EXPECT_EQ(box_of(12, 24).low_mm, (solid::Vec3{0, 70, 0}));
    EXPECT_EQ(box_of(12, 24).high_mm, (solid::Vec3{100, 90, 30}));
}

TEST_F(MeshFileTest, ColoursOf3mfComeBack) {
    std::vector<Colour> colours(12, kGrey);
    colours[3] = {215, 25, 28};
    colours[7] = {253, 174, 97};
    write_coloured_3mf(folder_ / "a.3mf", cube_, colours, "cube", "foreign");
    EXPECT_EQ(read_3mf_colours(folder_ / "a.3mf"), colours);
    expect_cube(read_mesh_file(folder_ / "a.3mf"));
    write_coloured_3mf(folder_ / "b.3mf", cube_, colours, "cube", "foreign");
    EXPECT_EQ(core::read_file(folder_ / "a.3mf"), core::read_file(folder_ / "b.3mf"));
}

TEST_F(MeshFileTest, ABrokenSurfaceIsColouredToo) {
    solid::Mesh open = cube_;
    open.triangles.pop_back();
    write_coloured_3mf(folder_ / "a.3mf", open, std::vector<Colour>(11, Colour{215, 25, 28}), "open", "foreign");
    EXPECT_EQ(read_3mf_colours(folder_ / "a.3mf").size(), 11u);
    EXPECT_THROW(write_coloured_3mf(folder_ / "b.3mf", open, {}, "open", "foreign"), core::InvalidInput);
}

TEST_F(MeshFileTest, NamesWhatIsWrong) {
    const auto expect = [&](const std::filesystem::path& path, const std::string& word) {
        fixtures::expect_refusal([&] { (void)read_mesh_file(path); }, {path.filename().string(), word});
    };
    expect(folder_ / "missing.stl", "cannot be opened");
    for (const char* name : {"empty.stl", "empty.obj", "empty.3mf", "empty.step"}) expect(write(name, ""), "");
    const std::string text = text_stl(cube_);
    expect(write("cut.stl", text.substr(0, text.size() / 2)), "endsolid");
    expect(write("none.stl", "solid none\nendsolid none\n"), "contains no triangles");
    write_stl(folder_ / "b.stl", cube_, "foreign");
    std::string bytes = core::read_file(folder_ / "b.stl");
    expect(write("short.stl", bytes.substr(0, bytes.size() - 10)), "bytes for 12 triangles");
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::memcpy(bytes.data() + 84 + 12, &nan, sizeof nan);
    expect(write("nan.stl", bytes), "not finite");
    const float far = 1e10F;  // no 3MF could show it
    std::memcpy(bytes.data() + 84 + 12, &far, sizeof far);
    expect(write("far.stl", bytes), "1e+10 mm; at most 1e+09 mm");
    expect(write("nan.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n"), "");
    expect(write("points.obj", "v 0 0 0\nv 1 0 0\n"), "");
    expect(write("text.3mf", "this is no zip"), "lib3mf");
    expect(write("text.step", "this is no STEP"), "STEP");
    EXPECT_THROW((void)read_mesh_file(write("a.ply", "ply")), core::InvalidInput);
}

}  // namespace
}  // namespace fusee::exchange
