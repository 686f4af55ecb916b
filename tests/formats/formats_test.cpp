#include <gtest/gtest.h>

#include <set>

#include "exchange/fixtures/expect_refusal.h"
#include "formats/only_file.h"

namespace fusee::formats {
namespace {

TEST(Formats, EachHasANameAnExtensionAndOneWriter) {
    std::set<std::string> names;
    int place = 0;
    for (const Format& format : all_formats()) {
        EXPECT_TRUE(names.insert(format.name).second) << format.name;
        EXPECT_EQ(format.extension[0], '.') << format.name;
        EXPECT_NE(format.write == nullptr, format.write_mesh == nullptr) << format.name;
        EXPECT_GE(format.place, place) << format.name;
        place = format.place;
    }
    EXPECT_GE(names.size(), 11u);
}

TEST(Formats, PlatesAreADefaultOfCutProcesses) {
    checks::Process process;
    EXPECT_EQ(default_formats(process), (std::vector<std::string>{"stl", "3mf", "scad", "dxf", "step", "drawing"}));
    process.kind = checks::ProcessKind::kLaser;
    EXPECT_EQ(default_formats(process), (std::vector<std::string>{"stl", "3mf", "scad", "dxf", "plates", "step", "drawing"}));
}

using ReadBackByExtension = fixtures::FolderTest;

TEST_F(ReadBackByExtension, MeshesCarryTheArmsOfADisc) {
    for (const char* name : {"stl", "3mf"}) {
        const auto part = fixtures::only_file(folder_, name, {"parallel", {1.0, 0.0}, {}, 0.0, 1});
        const auto errors = read_back(folder_, part);
        EXPECT_FALSE(errors.empty()) << name;
        for (const readback::ArmError& e : errors) EXPECT_TRUE(e.passed()) << e.reader << ' ' << e.worst_relative;
    }
}

TEST_F(ReadBackByExtension, AnUnknownExtensionIsRefused) {
    auto part = fixtures::only_file(folder_, "stl", {"parallel", {1.0, 0.0}, {}, 0.0, 1});
    std::filesystem::rename(folder_ / "k_se.stl", folder_ / "k_se.dwg");
    part.files[0].name = "k_se.dwg";
    fixtures::expect_refusal([&] { (void)read_back(folder_, part); }, {"k_se.dwg", "cannot be read back"});
}

}  // namespace
}  // namespace fusee::formats
