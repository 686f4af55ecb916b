#include <cmath>

#include "exchange/fixtures/disc.h"
#include "exchange/fixtures/parts.h"
#include "fusee/core/error.h"
#include "fusee/exchange/dxf.h"

// A planar part as plates: outlines, openings and ticks are what a shop cuts, known by hand on a disc of 12 mm about (2, 0).
namespace fusee::exchange {
namespace {

using StackTest = fixtures::FolderTest;

solid::Part disc_part() {
    solid::Part part;
    part.cam = fixtures::planar_cam();
    part.options = fixtures::keyed_options();
    part.section = {{1.0, -1.5}, {-0.5, 0.0}, {1.0, 1.5}};
    return part;
}

double radius(const Vec2& p) { return std::hypot(p[0] - 2.0, p[1]); }

TEST_F(StackTest, CoreIsTheFloorAndFlangesAreTheLips) {
    const auto plates = stack_drawings(disc_part(), "fusee test");
    ASSERT_EQ(plates.size(), 3u);
    const std::pair<const char*, double> outlines[] = {{"FLANGE", 13.0}, {"FLOOR", 11.5}, {"FLANGE", 13.0}};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& [name, rim] = outlines[i];
        ASSERT_NE(plates[i].layer(name), nullptr);
        const DxfPolyline& line = plates[i].layer(name)->polylines.at(0);
        EXPECT_TRUE(line.closed);
        for (const Vec2& p : line.points_mm) EXPECT_NEAR(radius(p), rim, 1e-9);
        EXPECT_FALSE(plates[i].layer(std::string(name) + "_SPLINE")->splines.empty());
        EXPECT_FALSE(plates[i].layer("BORE")->arcs.empty());
        EXPECT_EQ(plates[i].layer("DOWEL")->circles.size(), 2u);
        EXPECT_EQ(plates[i].layer("MARK")->polylines.size(), i + 1) << "a plate's number is that of its ticks";
        EXPECT_EQ(plates[i].layer("ANCHOR") != nullptr, i > 0) << "the cable's end goes up through core and flange";
        EXPECT_EQ(plates[i].layer("LEG_SLOT") != nullptr, i == 2) << "1 mm deep, a flange of 1.5 mm";
    }
    EXPECT_EQ(plates[1].provenance, "fusee test; plate 2 of 3 from below: core, 1.060 mm thick");
}

TEST_F(StackTest, DowelsOfAllPlatesAreInLine) {
    const auto plates = stack_drawings(disc_part(), "");
    for (const std::size_t i : {1u, 2u})
        for (const std::size_t k : {0u, 1u}) {
            EXPECT_EQ(plates[i].layer("DOWEL")->circles[k].centre_mm, plates[0].layer("DOWEL")->circles[k].centre_mm);
            EXPECT_EQ(plates[i].layer("DOWEL")->circles[k].radius_mm, 0.9) << "reamed through the stack";
        }
}

TEST_F(StackTest, RoundtripKeepsEveryLayer) {
    const auto plates = stack_drawings(disc_part(), "fusee test");
    write_dxf(folder_ / "core.dxf", plates[1]);
    const DxfDrawing back = read_dxf(folder_ / "core.dxf");
    EXPECT_EQ(back.provenance, plates[1].provenance);
    ASSERT_EQ(back.layers.size(), plates[1].layers.size());
    for (const DxfLayer& layer : plates[1].layers) {
        const DxfLayer* read = back.layer(layer.name);
        ASSERT_NE(read, nullptr) << layer.name;
        EXPECT_EQ(read->circles.size(), layer.circles.size());
        EXPECT_EQ(read->polylines.size(), layer.polylines.size());
        EXPECT_EQ(read->splines.size(), layer.splines.size());
    }
}

// Law: half the kerf outwards on outlines, inwards on openings; what is not cut is not there.
TEST_F(StackTest, KerfMovesEveryCutByHalfOfIt) {
    const auto nominal = stack_drawings(disc_part(), ""), moved = stack_kerf_drawings(disc_part(), 0.2, "");
    for (std::size_t i = 0; i < 3; ++i) {
        const char* outline = i == 1 ? "FLOOR" : "FLANGE";
        for (const Vec2& p : moved[i].layer(outline)->polylines.at(0).points_mm)
            EXPECT_NEAR(radius(p), radius(nominal[i].layer(outline)->polylines.at(0).points_mm[0]) + 0.1, 1e-9);
        EXPECT_NEAR(moved[i].layer("DOWEL")->circles[0].radius_mm, 0.8, 1e-12);
        EXPECT_EQ(moved[i].layer("MARK"), nullptr);
        EXPECT_EQ(moved[i].layer(std::string(outline) + "_SPLINE"), nullptr);
    }
    EXPECT_NEAR(moved[1].layer("ANCHOR")->circles[0].radius_mm, 0.9, 1e-12);
    EXPECT_NE(moved[0].provenance.find("kerf 0.2 mm"), std::string::npos);
    EXPECT_THROW((void)stack_kerf_drawings(disc_part(), 1.3, ""), core::InvalidInput) << "the slot of 1.2 mm would close";
}

}  // namespace
}  // namespace fusee::exchange
