#include "fusee/drawing/body_sheet.h"

#include <gtest/gtest.h>

#include <set>

#include "checks/fixture.h"

namespace fusee::drawing {
namespace {

/// A box of 40 x 12 x 20 mm, its upper half an own shape, with a hole of 5 mm along z through both and one of 3 mm along y.
std::vector<solid::Extrusion> bracket() {
    solid::Extrusion upper, lower;
    upper.half_x_mm = lower.half_x_mm = 20.0, upper.half_y_mm = 6.0, upper.length_mm = 10.0;
    upper.frame.translation() = Eigen::Vector3d(0.0, -30.0, 40.0);
    upper.holes = {{10.0, 0.0, 2.5}};
    lower = upper;
    lower.frame.translation().z() = 30.0;
    solid::Extrusion across;  // along y, on the upper face's side away from the joint
    across.frame.translation() = Eigen::Vector3d(0.0, -36.0, 25.0);
    across.frame.linear().col(0) = Eigen::Vector3d::UnitZ(), across.frame.linear().col(1) = Eigen::Vector3d::UnitX(),
    across.frame.linear().col(2) = Eigen::Vector3d::UnitY();
    across.half_x_mm = 5.0, across.half_y_mm = 20.0, across.length_mm = 12.0;
    across.holes = {{0.0, -8.0, 1.5}};
    return {upper, lower, across};
}

TEST(BodySheet, AHoleThroughTouchingShapesIsOne) {
    const std::vector<BodyHole> holes = holes_of(bracket());
    ASSERT_EQ(holes.size(), 2U);
    EXPECT_TRUE(holes[0].from_mm.isApprox(Eigen::Vector3d(10.0, -30.0, 50.0)));
    EXPECT_TRUE(holes[0].to_mm.isApprox(Eigen::Vector3d(10.0, -30.0, 30.0)));
    EXPECT_TRUE(holes[1].from_mm.isApprox(Eigen::Vector3d(-8.0, -24.0, 25.0)));
    EXPECT_EQ(holes[1].radius_mm, 1.5);
}

// Places by hand: x from the middle, y from the face towards the joint at -24, z from the upper face at 50.
TEST(BodySheet, HasViewsSizesAndAllHoles) {
    const checks::Fixture b = checks::spool();
    const std::vector<solid::Extrusion> shapes = bracket();
    const Sheet sheet = draw_sheet({b.part, b.spring, b.cable, b.process, "mine", "frame_rear", "by test"},
                                   {shapes, "frame: rear bracket", "the joint's axis",
                                    [](const BodyHole& h) { return h.radius_mm > 2.0 ? "bearing, H7" : "rod, H7"; }, 0.04});
    std::multiset<std::string> words;
    for (const Text& text : sheet.texts) words.insert(text.words);
    for (const char* word : {"frame: rear bracket", "40", "30", "12", "10.00", "-6.00", "0 to -20", "-8.00", "0 to -12", "-25.00", "5", "3",
                             "bearing, H7", "rod, H7", "0.04 mm"})
        EXPECT_TRUE(words.contains(word)) << word;
    for (const char* span : {"-20 to 20", "-12 to 0", "-10 to 0", "-20 to -10", "-30 to -20"}) EXPECT_TRUE(words.contains(span)) << span;
    EXPECT_GE(words.count("2"), 2U) << "in the table, and beside the hole";
    for (const Text& text : sheet.texts) EXPECT_TRUE(Sheet::kFrame.holds(box_of(text))) << text.words;
    for (const Stroke& stroke : sheet.strokes)
        for (const Point& p : stroke.line) EXPECT_TRUE(p[0] >= 19.9 && p[0] <= 410.1 && p[1] >= 9.9 && p[1] <= 287.1);
}

// A screw's hole near the corner, between the dashed lines of a rod's hole and the line from which the depth is measured.
TEST(BodySheet, NumbersStandOnNoLine) {
    const checks::Fixture b = checks::spool();
    solid::Extrusion top, wall = bracket()[2];
    top.half_x_mm = wall.half_y_mm = 86.4, top.half_y_mm = 8.0, top.length_mm = 14.0;
    top.frame.translation() = Eigen::Vector3d(0.0, -30.0, 40.0);
    top.holes = {{-81.4, 0.0, 1.25}};
    wall.frame.translation() = Eigen::Vector3d(0.0, -38.0, -25.0);
    wall.half_x_mm = 65.0, wall.length_mm = 16.0;
    wall.holes = {{10.0, -77.9, 3.0}};
    const std::vector<solid::Extrusion> shapes{top, wall};
    const Sheet sheet = draw_sheet({b.part, b.spring, b.cable, b.process, "mine", "frame_rear", "by test"},
                                   {shapes, "", "", [](const BodyHole&) { return std::string(); }});
    for (const Text& text : sheet.texts)
        for (const Stroke& stroke : sheet.strokes)
            for (std::size_t i = 1; i < stroke.line.size(); ++i)
                EXPECT_FALSE(box_of(text).meets(stroke.line[i - 1], stroke.line[i])) << text.words;
}

// The seam between the two halves is no edge; the edge of the part before is.
TEST(BodySheet, SeamsAreNoEdges) {
    const checks::Fixture b = checks::spool();
    const std::vector<solid::Extrusion> shapes = bracket();
    const Sheet sheet = draw_sheet({b.part, b.spring, b.cable, b.process, "mine", "frame_rear", "by test"},
                                   {shapes, "", "", [](const BodyHole&) { return std::string(); }});
    double outline = 0.0;
    for (const Stroke& stroke : sheet.strokes) {
        if (stroke.pen != Pen::kOutline || std::string(stroke.role) != "") continue;
        for (std::size_t i = 1; i < stroke.line.size(); ++i)
            if (stroke.line[i][1] < 230.0)
                outline += std::hypot(stroke.line[i][0] - stroke.line[i - 1][0], stroke.line[i][1] - stroke.line[i - 1][1]);
    }
    // front: around 40 x 30 and the hole of 3; above: around 40 x 12 and the hole of 5; at a scale of 2:1 or another of ISO 5455
    const double once = 2.0 * (40.0 + 30.0) + core::kPi * 3.0 + 2.0 * (40.0 + 12.0) + core::kPi * 5.0;
    EXPECT_NEAR(outline / once, std::round(outline / once), 0.02 * outline / once) << outline;
}

// A turned drum: its chords would be up to 0.01 mm shorter.
TEST(BodySheet, ACircleIsAsWideAsItsDiameter) {
    const checks::Fixture b = checks::spool();
    solid::Extrusion drum;
    drum.radius_mm = 41.196, drum.length_mm = 2.0;
    drum.frame = Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ());
    const Sheet sheet = draw_sheet({b.part, b.spring, b.cable, b.process, "mine", "capstan", "by test"},
                                   {{drum}, "", "", [](const BodyHole&) { return std::string(); }});
    std::multiset<std::string> words;
    for (const Text& text : sheet.texts) words.insert(text.words);
    EXPECT_EQ(words.count("82.39"), 2U);
    EXPECT_EQ(words.count("-41.2 to 41.2"), 2U);
}

}  // namespace
}  // namespace fusee::drawing
