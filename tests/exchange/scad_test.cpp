#include "fusee/exchange/scad.h"

#include "exchange/fixtures/disc.h"
#include "exchange/fixtures/distance.h"
#include "exchange/fixtures/expect_refusal.h"
#include "exchange/fixtures/parts.h"
#include "fusee/core/file.h"
#include "fusee/exchange/stl.h"
#include "long_form.h"

namespace fusee::exchange {
namespace {

struct PartCase {
    const char* name;
    cam::Cam cam;
    solid::PartOptions options;
};

class ScadTest : public fixtures::FolderTest {
protected:
    static solid::Part build(const PartCase& c) {
        auto part = solid::build_part(c.cam, c.options);
        if (!part) throw std::runtime_error(std::string(c.name) + ": " + core::to_line(part.refusal().front()));
        return *part;
    }
};

std::vector<PartCase> part_cases() {
    solid::PartOptions flanged = fixtures::keyed_options(), screwed = fixtures::overhung_options();
    flanged.flange_height = 0.8e-3;
    screwed.hub.kind = solid::HubKind::kThrough;
    screwed.hub.lock = solid::HubLock::kSetScrew;
    screwed.hub.screw_diameter = 2.5e-3;
    solid::PartOptions helix = fixtures::overhung_options();
    helix.flange_height = 0.5e-3;
    return {{"planar, keyway, leg slot", fixtures::planar_cam(), fixtures::keyed_options()},
            {"helix, overhung, D-flat", fixtures::helix_cam(), helix},
            {"planar, flanges", fixtures::planar_cam(), flanged},
            {"planar, boss and set screw", fixtures::planar_cam(), screwed}};
}

/// OpenSCAD is a second kernel: what it makes of the template has to be the direct solid.
TEST_F(ScadTest, OpenScadBuildsTheSameSolid) {
    for (const PartCase& c : fixtures::some_of(part_cases(), 2)) {
        const solid::Part part = build(c);
        write_scad(folder_ / "a.scad", part, "fusee test");
        render_scad(folder_ / "a.scad", folder_ / "a.stl");
        const solid::Mesh rendered = read_stl_openmesh(folder_ / "a.stl");
        const double volume = solid::volume_mm3(part.mesh);
        EXPECT_NEAR(solid::volume_mm3(rendered), volume, 3e-6 * volume) << c.name;
        // OpenSCAD keeps 2D outlines on a grid of 2^-16 mm and STL is single precision
        const double distance = std::max(fixtures::sampled_distance(rendered, part.mesh), fixtures::sampled_distance(part.mesh, rendered));
        EXPECT_LT(distance, 2e-4) << c.name;
        RecordProperty(c.name, std::to_string(distance));
    }
}

TEST_F(ScadTest, SameBytesTwiceAndFromTheFolderAsBuiltIn) {
    const solid::Part part = build(part_cases().front());
    write_scad(folder_ / "a.scad", part, "fusee test");
    write_scad(folder_ / "b.scad", part, "fusee test", std::filesystem::path(FUSEE_SOURCE_DIR) / "templates");
    const std::string text = core::read_file(folder_ / "a.scad");
    EXPECT_EQ(text, core::read_file(folder_ / "b.scad"));
    EXPECT_EQ(text.find("@"), text.npos);
    EXPECT_EQ(text.find("hull("), text.npos);
    for (const char* word :
         {"fusee test", "/* [Shaft and hub] */", "bore_diameter = 5;", "hub_lock = \"keyway\";", "label_text = \"\";", "detail = 1;"})
        EXPECT_NE(text.find(word), text.npos) << word;
}

TEST_F(ScadTest, CustomizerParametersChangeThePart) {
    const solid::Part part = build(part_cases().front());
    write_scad(folder_ / "a.scad", part, "fusee test");
    std::string text = core::read_file(folder_ / "a.scad");
    const auto set = [&](const std::string& from, const std::string& to) { text.replace(text.find(from), from.size(), to); };
    set("bore_diameter = 5;", "bore_diameter = 0;");
    set("label_text = \"\";", "label_text = \"A\";");
    set("detail = 1;", "detail = 2;");
    core::write_file(folder_ / "b.scad", text);
    render_scad(folder_ / "b.scad", folder_ / "b.stl");
    const double height = core::mm_from_m(part.z_high - part.z_low), bore = core::kPi * 2.6 * 2.6 * height;
    const double gained = solid::volume_mm3(read_stl_openmesh(folder_ / "b.stl")) - solid::volume_mm3(part.mesh);
    EXPECT_GT(gained, 0.9 * bore);  // the key's 2 mm2 more, the letter and coarser facets less
    EXPECT_LT(gained, 1.2 * bore);
}

TEST_F(ScadTest, RefusesAnUnknownPlaceholder) {
    for (const char* name : {"k_se.scad", "library.scad"}) core::write_file(folder_ / name, "x = @NO_SUCH@;");
    try {
        write_scad(folder_ / "a.scad", build(part_cases().front()), "", folder_);
        ADD_FAILURE();
    } catch (const core::InvalidInput& error) {
        EXPECT_EQ(error.value(), "@NO_SUCH@");
    }
    std::filesystem::remove(folder_ / "k_se.scad");
    core::write_file(folder_ / "library.scad", "");
    fixtures::expect_refusal([&] { write_scad(folder_ / "a.scad", build(part_cases().front()), "", folder_); }, {"k_se.scad"});
}

TEST_F(ScadTest, RenderFailuresSayWhatOpenScadSaid) {
    const auto fails = [&](const char* text, std::chrono::seconds timeout, const char* word) {
        core::write_file(folder_ / "bad.scad", text);
        fixtures::expect_refusal([&] { render_scad(folder_ / "bad.scad", folder_ / "bad.stl", timeout); }, {"bad.scad", word});
        EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);  // no STL, no leftovers
    };
    fails("cube(", std::chrono::seconds(60), "syntax error");
    fails("cube(undefined_size);", std::chrono::seconds(60), "WARNING");
    fails("minkowski() { sphere(10, $fn = 200); sphere(9, $fn = 200); }", std::chrono::seconds(1), "still running after 1 s");
}

}  // namespace
}  // namespace fusee::exchange
