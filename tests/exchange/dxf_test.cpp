#include "fusee/exchange/dxf.h"

#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/Splines>

#include "exchange/fixtures/disc.h"
#include "exchange/fixtures/expect_refusal.h"
#include "fusee/core/file.h"

namespace fusee::exchange {
namespace {

using DxfTest = fixtures::FolderTest;

DxfDrawing small_drawing() {
    DxfDrawing drawing;
    drawing.provenance = "fusee test";
    drawing.layers.push_back({"FLOOR", {{{{1.0 / 3.0, -2e-7}, {10.0, 0.1}, {12345.678901234567, 7.0}}, true}}, {}});
    drawing.layers.push_back({"BORE", {{{{0.0, 1.0}, {2.0, 3.0}}, false}}, {{{0.5, -0.25}, 2.6}}});
    drawing.layers.push_back({"SLOT", {}, {}, {}, {{{0.5, 1.0 / 3.0}, 2.5, -30.0, 200.1}}, {{{1.0 / 7.0, 2.0}, {3.0, -4.0}}}});
    return drawing;
}

/// A disc of pitch radius R about (e, 0) as the drawing's source: h = R + e cos psi, rho = R.
solid::Part disc_part(double radius, double offset) {
    solid::Part part;
    part.cam.options.cable_diameter = 1e-3;
    part.cam.groove_psi = {0.0, 2.0 * core::kPi};
    part.cam.path = [=](double psi) { return cam::PathPoint{psi, radius + offset * std::cos(psi), -offset * std::sin(psi), radius, 0.0}; };
    part.section = {{1.0, -1.5}, {-0.5, 0.0}, {1.0, 1.5}};
    return part;
}

// Designs of a study often have the same outlines: their bytes are read once, their stamps are their own, and a changed number is seen.
TEST_F(DxfTest, EqualDrawingsKeepTheirOwnStamps) {
    DxfDrawing drawing = small_drawing();
    for (const char* stamp : {"first", "second", "first"}) {
        drawing.provenance = stamp;
        write_dxf(folder_ / "a.dxf", drawing);
        EXPECT_EQ(read_dxf(folder_ / "a.dxf").provenance, stamp);
    }
    drawing.layers[1].circles[0].radius_mm = 2.7;
    write_dxf(folder_ / "a.dxf", drawing);
    EXPECT_EQ(read_dxf(folder_ / "a.dxf").layer("BORE")->circles[0].radius_mm, 2.7);
}

TEST_F(DxfTest, RoundtripIsExact) {
    const DxfDrawing drawing = small_drawing();
    write_dxf(folder_ / "a.dxf", drawing);
    const DxfDrawing back = read_dxf(folder_ / "a.dxf");
    EXPECT_EQ(back.provenance, "fusee test");
    ASSERT_EQ(back.layers.size(), 3u);
    for (const DxfLayer& layer : drawing.layers) {
        const DxfLayer* read = back.layer(layer.name);
        ASSERT_NE(read, nullptr);
        ASSERT_EQ(read->polylines.size(), layer.polylines.size());
        if (layer.polylines.empty()) continue;
        EXPECT_EQ(read->polylines[0].points_mm, layer.polylines[0].points_mm);  // shortest digits that give the number back
        EXPECT_EQ(read->polylines[0].closed, layer.polylines[0].closed);
    }
    ASSERT_EQ(back.layer("BORE")->circles.size(), 1u);
    EXPECT_EQ(back.layer("BORE")->circles[0].radius_mm, 2.6);
    EXPECT_EQ(back.layer("BORE")->circles[0].centre_mm, (Vec2{0.5, -0.25}));
    const DxfLayer& slot = *back.layer("SLOT");
    ASSERT_EQ(slot.arcs.size(), 1u);
    EXPECT_EQ(slot.arcs[0].centre_mm, (Vec2{0.5, 1.0 / 3.0}));
    EXPECT_EQ(slot.arcs[0].radius_mm, 2.5);
    EXPECT_EQ((Vec2{slot.arcs[0].begin_deg, slot.arcs[0].end_deg}), (Vec2{-30.0, 200.1}));
    ASSERT_EQ(slot.lines.size(), 1u);
    EXPECT_EQ(slot.lines[0].from_mm, (Vec2{1.0 / 7.0, 2.0}));
    EXPECT_EQ(slot.lines[0].to_mm, (Vec2{3.0, -4.0}));
    EXPECT_EQ(back.layer("MISSING"), nullptr);
}

TEST_F(DxfTest, SameBytesTwiceInMillimetresR2000) {
    write_dxf(folder_ / "a.dxf", small_drawing());
    write_dxf(folder_ / "b.dxf", small_drawing());
    const std::string bytes = core::read_file(folder_ / "a.dxf");
    EXPECT_EQ(bytes, core::read_file(folder_ / "b.dxf"));
    EXPECT_NE(bytes.find("AC1015"), std::string::npos);
    EXPECT_NE(bytes.find("$INSUNITS\n 70\n4\n"), std::string::npos);
    EXPECT_NE(bytes.find("LWPOLYLINE"), std::string::npos);
}

TEST_F(DxfTest, RefusesBrokenFilesByName) {
    write_dxf(folder_ / "whole.dxf", small_drawing());
    const std::string bytes = core::read_file(folder_ / "whole.dxf");
    std::string inches = bytes, fewer = bytes;
    inches.replace(bytes.find("$INSUNITS\n 70\n4"), 15, "$INSUNITS\n 70\n1");
    fewer.erase(bytes.find(" 10\n12345.678901234567"), std::string(" 10\n12345.678901234567\n 20\n7\n").size());
    core::write_file(folder_ / "cut.dxf", bytes.substr(0, bytes.size() / 2));
    core::write_file(folder_ / "inches.dxf", inches);
    core::write_file(folder_ / "fewer.dxf", fewer);
    core::write_file(folder_ / "empty.dxf", "");
    for (const char* name : {"cut.dxf", "inches.dxf", "fewer.dxf", "empty.dxf", "missing.dxf"})
        fixtures::expect_refusal([&] { (void)read_dxf(folder_ / name); }, {name});
}

TEST_F(DxfTest, OutlinesOfADiscStayWithinAMicrometre) {
    const DxfDrawing drawing = spool_drawing(disc_part(20e-3, 5e-3), "fusee test");
    const std::vector<std::pair<const char*, double>> radii{{"PITCH", 20.0}, {"FLOOR", 19.5}, {"FLANGE", 21.0}};
    for (const auto& [name, radius] : radii) {
        const DxfLayer* layer = drawing.layer(name);
        ASSERT_NE(layer, nullptr) << name;
        ASSERT_EQ(layer->polylines.size(), 1u);
        const auto& points = layer->polylines[0].points_mm;
        EXPECT_TRUE(layer->polylines[0].closed);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec2 &a = points[i], &b = points[(i + 1) % points.size()];
            EXPECT_NEAR(std::hypot(a[0] - 5.0, a[1]), radius, 1e-9);
            EXPECT_GT(std::hypot((a[0] + b[0]) / 2 - 5.0, (a[1] + b[1]) / 2), radius - 1.001e-3) << name << " " << i;
        }
    }
    ASSERT_EQ(drawing.layer("MARK")->polylines.size(), 1u);
    EXPECT_FALSE(drawing.layer("MARK")->polylines[0].closed);
    EXPECT_NEAR(drawing.layer("MARK")->polylines[0].points_mm.back()[0], 26.0, 1e-3);
}

/// Largest distance of the splines from a circle about (5, 0), at 20 places of each span [mm].
double off_circle(const std::vector<brep::PlaneSpline>& splines, double radius) {
    double worst = 0.0;
    for (const brep::PlaneSpline& s : splines) {
        Eigen::Matrix2Xd control(2, static_cast<Eigen::Index>(s.control_mm.size()));
        for (std::size_t i = 0; i < s.control_mm.size(); ++i)
            control.col(static_cast<Eigen::Index>(i)) << s.control_mm[i][0], s.control_mm[i][1];
        const Eigen::Map<const Eigen::RowVectorXd> knots(s.knots.data(), static_cast<Eigen::Index>(s.knots.size()));
        const Eigen::Spline<double, 2, Eigen::Dynamic> curve(knots, control);
        for (std::size_t k = 1; k < s.knots.size(); ++k)
            for (int i = 0; i < 20 && s.knots[k] > s.knots[k - 1]; ++i) {
                const Eigen::Vector2d p = curve(s.knots[k - 1] + (s.knots[k] - s.knots[k - 1]) * i / 20.0);
                worst = std::max(worst, std::abs(std::hypot(p[0] - 5.0, p[1]) - radius));
            }
    }
    return worst;
}

/// A roller's arm is the slope of its lift: its rim is drawn finer than the floor of a cable, which is the arm itself.
TEST_F(DxfTest, SplinesOfARimAreFinerThanThoseOfAFloor) {
    solid::Part part = disc_part(20e-3, 5e-3);
    EXPECT_LT(off_circle(spool_drawing(part, "").layer("FLOOR_SPLINE")->splines, 19.5), 2.2e-4);
    part.cam.options.family = cam::Family::kRoller;
    part.cam.options.cable_diameter = 0.0;
    EXPECT_LT(off_circle(spool_drawing(part, "").layer("FLOOR_SPLINE")->splines, 20.0), 1.1e-5);
}

TEST_F(DxfTest, AnArmsPivotIsACrossOnALayerOfItsOwn) {
    solid::Part part = disc_part(20e-3, 5e-3);
    EXPECT_EQ(spool_drawing(part, "fusee test").layer("PIVOT"), nullptr);
    part.cam.options.family = cam::Family::kRoller;
    EXPECT_EQ(spool_drawing(part, "fusee test").layer("PIVOT"), nullptr) << "a slide has none";
    part.cam.options.roller.follower = cam::FollowerKind::kArm;
    part.cam.options.roller.arm.pivot = 60e-3;
    part.cam.options.roller.direction = core::kPi / 6.0;
    write_dxf(folder_ / "a.dxf", spool_drawing(part, "fusee test"));
    const DxfDrawing back = read_dxf(folder_ / "a.dxf");
    ASSERT_NE(back.layer("PIVOT"), nullptr);
    ASSERT_EQ(back.layer("PIVOT")->lines.size(), 2u);
    const DxfLine &flat = back.layer("PIVOT")->lines[0], &upright = back.layer("PIVOT")->lines[1];
    EXPECT_NEAR(0.5 * (flat.from_mm[0] + flat.to_mm[0]), 30.0 * std::sqrt(3.0), 1e-9);
    EXPECT_NEAR(flat.from_mm[1], 30.0, 1e-9);
    EXPECT_NEAR(flat.to_mm[1], 30.0, 1e-9);
    EXPECT_NEAR(upright.from_mm[0], 30.0 * std::sqrt(3.0), 1e-9);
    EXPECT_NEAR(0.5 * (upright.from_mm[1] + upright.to_mm[1]), 30.0, 1e-9);
    EXPECT_EQ(kerf_drawing(part, 0.2, "").layer("PIVOT"), nullptr) << "no beam cuts it";
}

TEST_F(DxfTest, SplinesComeBackExactlyAndBrokenOnesAreRefused) {
    const DxfDrawing drawing = spool_drawing(disc_part(20e-3, 5e-3), "fusee test");
    write_dxf(folder_ / "a.dxf", drawing);
    const DxfDrawing back = read_dxf(folder_ / "a.dxf");
    for (const char* name : {"PITCH_SPLINE", "FLOOR_SPLINE", "FLANGE_SPLINE"}) {
        const auto &written = drawing.layer(name)->splines, &read = back.layer(name)->splines;
        ASSERT_EQ(read.size(), written.size()) << name;
        ASSERT_FALSE(read.empty()) << name;
        for (std::size_t i = 0; i < read.size(); ++i) {
            EXPECT_EQ(read[i].degree, 3);
            EXPECT_EQ(read[i].knots, written[i].knots);
            EXPECT_EQ(read[i].control_mm, written[i].control_mm);
        }
    }
    std::string bytes = core::read_file(folder_ / "a.dxf");
    bytes.erase(bytes.find(" 40\n", bytes.find("SPLINE\n  5")), std::string(" 40\n0\n").size());
    core::write_file(folder_ / "fewer.dxf", bytes);
    fixtures::expect_refusal([&] { (void)read_dxf(folder_ / "fewer.dxf"); }, {"fewer.dxf", "SPLINE"});
    bytes = core::read_file(folder_ / "a.dxf");
    const std::size_t knots = bytes.find('\n', bytes.find(" 72\n", bytes.find("SPLINE\n  5"))) + 1;
    bytes.replace(knots, bytes.find('\n', knots) - knots, "888888888");  // 7 GB
    core::write_file(folder_ / "more.dxf", bytes);
    fixtures::expect_refusal([&] { (void)read_dxf(folder_ / "more.dxf"); },
                             {"more.dxf", "line ", "a SPLINE of 888888888 parts in a file of"});
    bytes = core::read_file(folder_ / "a.dxf");
    core::write_file(folder_ / "long.dxf", bytes.insert(bytes.find('\n'), 3000, ' '));  // dxflib would not end
    fixtures::expect_refusal([&] { (void)read_dxf(folder_ / "long.dxf"); }, {"long.dxf", "line 1: 300", "at most 1022"});
}

// Law: half the kerf outwards on the flange, inwards on every side of the bore and its key.
TEST_F(DxfTest, KerfMovesOutlinesByHalfOfIt) {
    solid::Part part = disc_part(20e-3, 5e-3);
    part.options.hub.lock = solid::HubLock::kKeyway;
    const DxfDrawing nominal = spool_drawing(part, ""), moved = kerf_drawing(part, 0.2, "");
    EXPECT_EQ(moved.layers.size(), 2u);
    for (const Vec2& p : moved.layer("FLANGE")->polylines.at(0).points_mm) EXPECT_NEAR(std::hypot(p[0] - 5.0, p[1]), 21.1, 1e-9);
    const DxfLayer &bore = *nominal.layer("BORE"), &cut = *moved.layer("BORE");
    ASSERT_EQ(cut.lines.size(), 3u) << "the key's sides and bottom";
    for (std::size_t i = 0; i < 2; ++i) {  // its corners
        EXPECT_NEAR(cut.lines[i].from_mm[0], bore.lines[i].from_mm[0] - 0.1, 1e-12);
        EXPECT_NEAR(std::abs(cut.lines[i].from_mm[1]), std::abs(bore.lines[i].from_mm[1]) - 0.1, 1e-12);
    }
    ASSERT_EQ(cut.arcs.size(), 1u);
    EXPECT_NEAR(cut.arcs[0].radius_mm, 2.5, 1e-12);
    EXPECT_THROW((void)kerf_drawing(part, 2.5, ""), core::InvalidInput);  // wider than the key
}

TEST_F(DxfTest, BoreIsACircleOrAClosedOutlineWithKey) {
    solid::Part part = disc_part(20e-3, 5e-3);
    part.options.hub.lock = solid::HubLock::kPlain;
    const DxfLayer plain = *spool_drawing(part, "").layer("BORE");
    ASSERT_EQ(plain.circles.size(), 1u);
    EXPECT_NEAR(plain.circles[0].radius_mm, 2.6, 1e-12);  // 5 mm and 0.2 mm of clearance
    part.options.hub.lock = solid::HubLock::kKeyway;
    const DxfLayer keyed = *spool_drawing(part, "").layer("BORE");
    EXPECT_EQ(keyed.arcs.size(), 1u);
    EXPECT_EQ(keyed.lines.size(), 3u);
    EXPECT_TRUE(keyed.circles.empty());
}

/// Area within a closed chain of lines and arcs [mm^2], by the integral of x dy - y dx; each end must be another's begin.
double enclosed(const DxfLayer& layer) {
    double twice = 0.0;
    std::vector<Vec2> begins, ends;
    for (const DxfLine& l : layer.lines) {
        twice += l.from_mm[0] * l.to_mm[1] - l.to_mm[0] * l.from_mm[1];
        begins.push_back(l.from_mm), ends.push_back(l.to_mm);
    }
    for (const DxfArc& a : layer.arcs) {
        const double from = core::rad_from_deg(a.begin_deg), to = core::rad_from_deg(a.end_deg), r = a.radius_mm;
        twice +=
            r * r * (to - from) + r * (a.centre_mm[0] * (std::sin(to) - std::sin(from)) - a.centre_mm[1] * (std::cos(to) - std::cos(from)));
        begins.push_back({a.centre_mm[0] + r * std::cos(from), a.centre_mm[1] + r * std::sin(from)});
        ends.push_back({a.centre_mm[0] + r * std::cos(to), a.centre_mm[1] + r * std::sin(to)});
    }
    for (const Vec2& end : ends)
        EXPECT_TRUE(
            std::any_of(begins.begin(), begins.end(), [&](const Vec2& b) { return std::hypot(b[0] - end[0], b[1] - end[1]) < 1e-9; }));
    return 0.5 * twice;
}

// Known: a keyed bore of 5.2 mm, a slot of 1.4 x 2.4 mm, a flat 0.5 mm deep; arcs are exact, so are the areas.
TEST_F(DxfTest, BoreAndSlotAreLinesAndExactArcs) {
    solid::Part part = disc_part(20e-3, 5e-3);
    solid::FeatureOptions& f = part.options.features;
    f.leg_slot_width = 1.4e-3, f.leg_slot_length = 2.4e-3, f.leg_slot_radius = 6e-3, f.leg_slot_depth = 1e-3;
    part.options.hub.lock = solid::HubLock::kDFlat;
    part.options.hub.flat_depth = 0.5e-3;
    write_dxf(folder_ / "a.dxf", spool_drawing(part, ""));
    const DxfDrawing back = read_dxf(folder_ / "a.dxf");
    ASSERT_NE(back.layer("LEG_SLOT"), nullptr);
    EXPECT_EQ(back.layer("LEG_SLOT")->arcs.size(), 2u) << "two half circles";
    EXPECT_NEAR(enclosed(*back.layer("LEG_SLOT")), core::kPi * 0.49 + 1.4, 1e-9);
    const double open = std::acos(2.1 / 2.6);
    EXPECT_NEAR(enclosed(*back.layer("BORE")), 2.6 * 2.6 * (core::kPi - open) + 2.1 * 2.6 * std::sin(open), 1e-9);
    part.options.hub.lock = solid::HubLock::kKeyway;
    const DxfLayer keyed = *spool_drawing(part, "").layer("BORE");
    EXPECT_GT(enclosed(keyed), core::kPi * 2.6 * 2.6) << "the key is outside the round bore";
}

// Known: h = R + e cos psi; the hole touches the pitch curve from inside.
TEST_F(DxfTest, AnchorHoleIsACircleOnTheCable) {
    solid::Part part = disc_part(20e-3, 5e-3);
    part.options.features.anchor_hole_diameter = 1.6e-3;
    part.cam.anchor_psi = 1.0;
    const DxfDrawing drawing = spool_drawing(part, "");
    const DxfLayer* anchor = drawing.layer("ANCHOR");
    ASSERT_NE(anchor, nullptr);
    ASSERT_EQ(anchor->circles.size(), 1u);
    EXPECT_NEAR(anchor->circles[0].radius_mm, 0.8, 1e-12);
    EXPECT_NEAR(std::hypot(anchor->circles[0].centre_mm[0] - 5.0, anchor->circles[0].centre_mm[1]), 20.0 - 0.8, 1e-9);
    part.options.features.anchor_hole_diameter = 0.0;
    EXPECT_EQ(spool_drawing(part, "").layer("ANCHOR"), nullptr);
    EXPECT_EQ(spool_drawing(part, "").layer("LEG_SLOT"), nullptr);
}

}  // namespace
}  // namespace fusee::exchange
