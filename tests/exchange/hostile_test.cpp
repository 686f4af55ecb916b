#include <fmt/format.h>
#include <sys/stat.h>

#include "exchange/fixtures/disc.h"
#include "exchange/fixtures/expect_refusal.h"
#include "exchange/fixtures/read_3mf.h"
#include "exchange/fixtures/zip.h"
#include "fusee/core/file.h"
#include "fusee/exchange/mesh_file.h"
#include "fusee/exchange/step.h"
#include "fusee/exchange/stl.h"
#include "fusee/exchange/three_mf.h"
#include "fusee/solid/mesh.h"
#include "solid/fixture.h"

// Files that no program would write: each is refused by name, with the place where there is one, before a library can trip over it.
namespace fusee::exchange {
namespace {

class Hostile : public fixtures::FolderTest {
protected:
    std::filesystem::path write(const std::string& name, const std::string& text) const {
        core::write_file(folder_ / name, text);
        return folder_ / name;
    }
    static void expect(const std::filesystem::path& path, std::initializer_list<std::string> words) {
        fixtures::expect_refusal([&] { (void)read_mesh_file(path); }, words);
    }
    /// A STEP file of one disc.
    std::string step() const {
        const cam::Cam cam = solid::test::disc(12e-3, 3e-3, 0.8e-3);
        write_step(folder_ / "whole.step", brep::build(solid::build_part(cam, solid::test::plain()).value()).value(), "k_se", "foreign");
        return core::read_file(folder_ / "whole.step");
    }
    const solid::Mesh cube_ = solid::prism({{0, 0}, {10, 0}, {10, 10}, {0, 10}}, 0.0, 10.0);
};

TEST_F(Hostile, StepReferencesAreResolvedFirst) {
    const std::string whole = step();
    const std::size_t at = whole.find("= CARTESIAN_POINT"), begin = whole.rfind('#', at), end = whole.find(';', at);
    ASSERT_NE(at, std::string::npos);
    const std::string number = whole.substr(begin, whole.find(' ', begin) - begin);
    const auto path = write("point.step", whole.substr(0, begin) + whole.substr(end + 1));
    expect(path, {"point.step", "line ", number + " is referenced but not defined"});
    fixtures::expect_refusal([&] { (void)StepFile(path); }, {"point.step", number});
    expect(write("twice.step", whole.substr(0, end + 1) + whole.substr(begin)), {number + " is defined twice"});
}

TEST_F(Hostile, StepValuesAreFiniteAndClosed) {
    const std::string whole = step();
    const std::size_t at = whole.find("CARTESIAN_POINT"), value = whole.find(",(", at) + 2, end = whole.find(',', value);
    const auto with = [&](const std::string& text) { return whole.substr(0, value) + text + whole.substr(end); };
    for (const std::string word : {"nan", "-nan", "inf", "NAN", "1.E400", "1.2.3", "1.#INF", "-"})
        expect(write("value.step", with(word)), {"value.step", "line "});
    expect(write("deep.step", with(std::string(100'000, '('))), {"nested more than 100 deep"});
    expect(write("open.step", with("(1.")), {"not closed"});
    expect(write("text.step", with("'1.")), {"line "});
    EXPECT_NO_THROW((void)read_mesh_file(write("small.step", with("1.E-400"))));
    expect(write("cut.step", whole.substr(0, whole.size() / 2)), {"END-ISO-10303-21"});
}

TEST_F(Hostile, ObjFacesAndPoints) {
    const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    expect(write("a.obj", points + "f 1 2 4\n"), {"a.obj", "line 4", "point 4; the file has 3 points"});
    expect(write("b.obj", points + "f 1 2 0\n"), {"line 4", "point 0"});
    expect(write("c.obj", points + "f -1 -2 -4\n"), {"line 4", "point -4"});
    expect(write("d.obj", "v 0 0 0\nv nan 0 0\n"), {"line 2", "not a finite number"});
    expect(write("e.obj", "v 0 1e400 0\n"), {"line 1", "not a finite number"});
    expect(write("g.obj", points + "f 1/1 2/x a\n"), {"line 4", "not the number of a point"});
    EXPECT_NO_THROW((void)read_mesh_file(write("h.obj", "v +0 1e-400 0\r\nv 1 0 0 1\nv 0 1 0\nf 1 2 \\\n-1\n")));
    std::string many = points + "f";
    for (int i = 0; i < 600'000; ++i) many += fmt::format(" {}", 1 + i % 3);
    expect(write("many.obj", many + "\n"), {"line 4", "more than 5000 corners"});
}

TEST_F(Hostile, ComponentsAreCountedBeforeTheyAreCopied) {
    const MeshFile file = read_mesh_file(write("two.3mf", fixtures::three_mf(fixtures::nested_model(2))));
    EXPECT_EQ(file.mesh.triangles.size(), 400u);
    expect(write("seven.3mf", fixtures::three_mf(fixtures::nested_model(7))), {"seven.3mf", "4e+07 triangles", "at most 5000000"});
    expect(write("deep.3mf", fixtures::three_mf(fixtures::nested_model(200, 1))), {"deep.3mf", "more than 100 deep"});
}

TEST_F(Hostile, OnlyRegularFilesAreRead) {
    std::filesystem::create_directory(folder_ / "folder.stl");
    expect(folder_ / "folder.stl", {"folder.stl", "not a regular file"});
    ASSERT_EQ(::mkfifo((folder_ / "fifo.stl").c_str(), 0600), 0);
    expect(folder_ / "fifo.stl", {"fifo.stl", "not a regular file"});
    expect(folder_ / "missing.stl", {"missing.stl", "does not exist"});
}

TEST_F(Hostile, NamesWithMarkupComeBack) {
    const std::string name = "a&b<\"c\">'d'", spoilt = "x\x01y\xff";
    write_3mf(folder_ / "a.3mf", {{name, cube_}, {spoilt, cube_}}, name);
    const auto objects = read_3mf_objects(folder_ / "a.3mf");
    EXPECT_EQ(objects.at(0).name, name);
    EXPECT_EQ(objects.at(1).name, "x\xEF\xBF\xBDy\xEF\xBF\xBD");
    EXPECT_EQ(read_3mf_description(folder_ / "a.3mf"), name);
    for (const std::string& text : {name, spoilt}) {
        write_coloured_3mf(folder_ / "b.3mf", cube_, std::vector<Colour>(12, kGrey), text, text);
        EXPECT_EQ(read_3mf_objects(folder_ / "b.3mf").at(0).mesh.triangles.size(), 12u);
    }
    EXPECT_EQ(read_3mf_description(folder_ / "b.3mf"), "x\xEF\xBF\xBDy\xEF\xBF\xBD");
}

TEST_F(Hostile, DeepJsonIsNoPart) {
    for (const char bracket : {'[', '{'})
        fixtures::expect_refusal([&] { (void)read_part_file(write("a.json", std::string(100'000, bracket))); },
                                 {"a.json", "at most 64 deep"});
    fixtures::expect_refusal([&] { (void)read_part_file(write("b.json", "{\"part\": \"[[\\\"[[\"")); }, {"b.json:1:", "not valid JSON"});
}

/// Readers that are no fusee: what becomes of the child is said of the file.
class Apart : public Hostile {
protected:
    void expect_of(const std::string& script, std::initializer_list<std::string> words) const {
        const auto path = write("a.step", "ISO-10303-21;");
        fixtures::expect_refusal([&] { (void)read_mesh_isolated(path, {"/bin/sh", "-c", script}); }, words);
    }
};

TEST_F(Apart, ACrashIsTheFilesFault) {
    expect_of("kill -SEGV $$", {"a.step", "OpenCASCADE crashed reading it (signal 11)", "the file is not valid"});
    expect_of("exit 7", {"a.step", "crashed reading it (exit code 7)"});
    expect_of("printf M", {"crashed"});
    expect_of("printf Mgarbagegarbagegarbagegarbagegarbage", {"crashed"});
    expect_of("printf O; exit 0", {"ran out of memory", "2048 MB"});
    expect_of("printf 'Rline 3: no'", {"a.step: line 3: no"});
    expect_of("ulimit -c 0; ulimit -S -t 1; while :; do :; done", {"did not finish reading it", "10 s of processor time"});
}

TEST_F(Apart, TheReaderIsGivenTheFile) {
    write_stl(folder_ / "a b.stl", cube_, "foreign");
    // What serve_mesh_file would send: no unit, no items, one point, no triangle.
    const std::string script =
        "test -f \"$0\" && printf 'M\\0\\0\\0\\0\\0\\0\\0\\0\\0\\0\\0\\0\\0\\0\\0\\0\\1\\0\\0\\0\\0\\0\\0\\0' && head -c 32 /dev/zero";
    const MeshFile file = read_mesh_isolated(folder_ / "a b.stl", {"/bin/sh", "-c", script});
    EXPECT_EQ(file.mesh.points_mm, (std::vector<solid::Vec3>{{0, 0, 0}}));
    EXPECT_TRUE(file.mesh.triangles.empty());
    EXPECT_THROW((void)read_mesh_isolated(folder_ / "missing.stl", {"/bin/sh"}), core::IoError);
    EXPECT_THROW((void)read_mesh_isolated(folder_ / "a.ply", {"/bin/sh"}), core::InvalidInput);
}

}  // namespace
}  // namespace fusee::exchange
