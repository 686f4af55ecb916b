#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <random>

#include "app/run.h"
#include "exchange/fixtures/zip.h"
#include "fusee/core/error.h"
#include "fusee/exchange/mesh_file.h"

// Meshes with a few changed bytes, lines and numbers, read as `fusee check` reads them: each gives a mesh or is refused by name.
// FUSEE_MUTATIONS=1000 makes that many of each kind.
namespace fusee::app {
namespace {

using Generator = std::mt19937_64;  // its numbers are the same everywhere; distributions' are not

std::size_t below(Generator& g, std::size_t count) { return count == 0 ? 0 : g() % count; }

/// Where the k-th number of the text stands; wraps around.
std::pair<std::size_t, std::size_t> number_at(const std::string& text, std::size_t from) {
    const std::size_t begin = text.find_first_of("0123456789", from);
    if (begin == std::string::npos) return {text.size(), 0};
    const std::size_t end = std::min(text.find_first_not_of("0123456789.eE+-", begin), text.size());
    return {begin, end - begin};
}

std::string mutated(std::string text, Generator& g) {
    static constexpr const char* kNumbers[] = {
        "nan", "-1", "0", "1e400", "1e38", "4294967295", "", "-inf", "1e-320", "2", "18446744073709551616", "#1"};
    for (std::size_t changes = 1 + below(g, 2); changes > 0 && !text.empty(); --changes) {
        const std::size_t at = below(g, text.size());
        switch (below(g, 7)) {
            case 0:
                text[at] = static_cast<char>(g());
                break;
            case 1:
                text.erase(at, 1 + below(g, 40));
                break;
            case 2:
                text.insert(at, text.substr(below(g, text.size()), 1 + below(g, 200)));
                break;
            case 3: {  // a line goes
                const std::size_t begin = text.rfind('\n', at), first = begin == std::string::npos ? 0 : begin;
                text.erase(first, std::min(text.find('\n', at), text.size()) - first);
                break;
            }
            case 4:
                text.resize(at);
                break;
            default: {
                const auto [begin, length] = number_at(text, at);
                text.replace(begin, length, kNumbers[below(g, std::size(kNumbers))]);
            }
        }
    }
    return text;
}

class MeshMutation : public Program {
protected:
    /// @param wrap makes the file of the changed text
    void read_all(const std::string& whole, const std::string& ending, std::string (*wrap)(const std::string&)) const {
        const char* const asked = std::getenv("FUSEE_MUTATIONS");
        const int count = asked == nullptr ? 40 : std::atoi(asked);
        const fs::path path = folder_ / ("a" + ending);
        int meshes = 0, refused = 0, crashed = 0;
        double longest = 0.0;
        for (int i = 0; i < count; ++i) {
            Generator g(static_cast<std::uint64_t>(i));
            core::write_file(path, wrap(i == 0 ? whole : mutated(whole, g)));
            const auto begin = std::chrono::steady_clock::now();
            try {
                (void)exchange::read_mesh_isolated(path, {FUSEE_PROGRAM, exchange::kReadMesh});
                ++meshes;
            } catch (const core::IoError& e) {
                EXPECT_TRUE(std::string(e.what()).starts_with(path.string() + ": ")) << e.what();
                ++refused;
                const std::string what = e.what();
                const bool ended = what.find("crashed") != std::string::npos || what.find("did not finish") != std::string::npos;
                if (ended && asked != nullptr)
                    fs::copy_file(path, fs::temp_directory_path() / fmt::format("crashed_{}{}", i, ending),
                                  fs::copy_options::overwrite_existing);
                crashed += ended ? 1 : 0;
            }
            ASSERT_TRUE(i > 0 || meshes == 1) << "unchanged it is read";
            longest = std::max(longest, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
        }
        EXPECT_EQ(meshes + refused, count);
        EXPECT_GT(refused, 0);
        fmt::print("{}: {} meshes, {} refused, of these {} readers ended; longest {:.1f} s\n", ending, meshes, refused, crashed, longest);
    }
    static std::string as_it_is(const std::string& text) { return text; }
};

std::string cube_obj() {
    return "o cube\nv 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nv 0 0 10\nv 10 0 10\nv 10 10 10\nv 0 10 10\n"
           "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
}

std::string tetrahedron_stl(bool text) {
    static constexpr float kPoints[4][3] = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 0, 10}};
    static constexpr int kFaces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    std::string out = text ? "solid t\n" : std::string(80, 'x') + std::string("\4\0\0\0", 4);
    for (const auto& face : kFaces) {
        if (text) out += "facet normal 0 0 0\nouter loop\n";
        if (!text) out += std::string(12, '\0');
        for (const int p : face) {
            if (text) out += fmt::format("vertex {} {} {}\n", kPoints[p][0], kPoints[p][1], kPoints[p][2]);
            if (!text) out.append(reinterpret_cast<const char*>(kPoints[p]), sizeof kPoints[p]);
        }
        out += text ? std::string("endloop\nendfacet\n") : std::string(2, '\0');
    }
    return text ? out + "endsolid t\n" : out;
}

TEST_F(MeshMutation, BinaryStl) { read_all(tetrahedron_stl(false), ".stl", as_it_is); }
TEST_F(MeshMutation, TextStl) { read_all(tetrahedron_stl(true), ".stl", as_it_is); }
TEST_F(MeshMutation, Obj) { read_all(cube_obj(), ".obj", as_it_is); }
TEST_F(MeshMutation, ThreeMf) { read_all(fixtures::nested_model(2), ".3mf", fixtures::three_mf); }
TEST_F(MeshMutation, ThreeMfArchive) { read_all(fixtures::three_mf(fixtures::nested_model(1)), ".3mf", as_it_is); }
TEST_F(MeshMutation, Step) { read_all(core::read_file(fs::path(FUSEE_SOURCE_DIR) / "tests/app/fixtures/box.step"), ".step", as_it_is); }

TEST_F(MeshMutation, CheckNamesTheFileAndEndsWith2) {
    const std::string step = core::read_file(fs::path(FUSEE_SOURCE_DIR) / "tests/app/fixtures/box.step");
    const std::size_t at = step.find("CARTESIAN_POINT"), begin = step.rfind('#', at), end = step.find(';', at);
    write("point.step", step.substr(0, begin) + step.substr(end + 1));
    const Ended point = run("check point.step --process fdm");
    EXPECT_EQ(point.code, 2) << point.all();
    expect_words(point.err, {"point.step: line ", "is referenced but not defined"});
    write("box.step", step);
    EXPECT_EQ(run("check box.step --process fdm").code, 0);
}

}  // namespace
}  // namespace fusee::app
