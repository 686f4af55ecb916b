#include "fusee/drawing/drawing.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <future>

#include "exchange/fixtures/disc.h"
#include "exchange/fixtures/parts.h"
#include "fusee/core/file.h"
#include "fusee/drawing/inspection.h"
#include "fusee/drawing/sheet.h"

namespace fusee::drawing {
namespace {

/// A cam from the fixtures with working positions: arms and tensions that rise by hand.
cam::Cam working(cam::Cam cam) {
    for (int i = 0; i < 200; ++i) {
        cam::Contact row;
        row.arm = {0.1, 0.01 * i, 10e-3 + 1e-5 * i, 0.0, 0.0, 5.0 + 0.1 * i, 0.0};
        cam.working.push_back(row);
    }
    return cam;
}

/// A round helix of `turns` turns.
cam::Cam long_helix(double turns) {
    cam::Cam cam = fixtures::helix_cam(10e-3, 0.0, 6e-3);
    cam.working_psi = {0.0, turns * 2.0 * core::kPi};
    cam.groove_psi = {-0.4, cam.working_psi.high + 0.4};
    return cam;
}

/// Half a turn that rises by less than its cable.
cam::Cam shallow_helix() {
    cam::Cam cam = fixtures::helix_cam(10e-3, 0.0, 0.8e-3);
    cam.working_psi = {0.1, 3.1};
    cam.groove_psi = {-0.7, 3.8};
    return cam;
}

solid::PartOptions plain_options() {
    solid::PartOptions options;
    options.hub.lock = solid::HubLock::kPlain;
    options.chordal_error = 20e-6;
    return options;
}

solid::PartOptions screwed_options() {
    solid::PartOptions options = fixtures::keyed_options();
    options.hub.lock = solid::HubLock::kSetScrew;
    options.hub.screw_diameter = 2.5e-3;
    options.hub.boss_diameter = 12e-3;
    options.hub.boss_height = 6e-3;
    return options;
}

solid::PartOptions keyed_overhung() {
    solid::PartOptions options = fixtures::overhung_options();
    options.hub.lock = solid::HubLock::kKeyway;
    return options;
}

/// A round roller cam beside its axis.
cam::Cam roller_cam() {
    cam::Cam cam = fixtures::planar_cam(30e-3, 5e-3);
    cam.kind = cam::PartKind::kParallel;
    cam.options.family = cam::Family::kRoller;
    cam.options.cable_diameter = 0.0;
    return cam;
}

/// The same with the roller on an arm, its pivot to the left.
cam::Cam roller_arm_cam() {
    cam::Cam cam = roller_cam();
    cam.options.roller.follower = cam::FollowerKind::kArm;
    cam.options.roller.arm.pivot = 60e-3;
    cam.options.roller.direction = core::kPi;
    return cam;
}

solid::PartOptions roller_options() {
    solid::PartOptions options = fixtures::keyed_options();
    options.features.anchor_hole_diameter = options.features.leg_slot_width = options.flange_height = 0.0;
    return options;
}

struct Case {
    const char* name;
    cam::Cam cam;
    solid::PartOptions options;
};

std::vector<Case> cases() {
    return {{"keyed", fixtures::planar_cam(), fixtures::keyed_options()},
            {"overhung", fixtures::planar_cam(5e-3, 0.5e-3), fixtures::overhung_options()},
            {"overhung_key", fixtures::planar_cam(8e-3, 1e-3), keyed_overhung()},
            {"set_screw", fixtures::planar_cam(), screwed_options()},
            {"large", fixtures::planar_cam(90e-3, 20e-3), fixtures::keyed_options()},
            {"helix", fixtures::helix_cam(), fixtures::keyed_options()},
            {"four_turns", long_helix(4.0), plain_options()},
            {"shallow_helix", shallow_helix(), plain_options()},
            {"roller", roller_cam(), roller_options()},
            {"roller_arm", roller_arm_cam(), roller_options()}};
}

class Drawn : public testing::TestWithParam<std::size_t> {
protected:
    static const Case& chosen() {
        static const std::vector<Case> all = cases();
        return all[GetParam()];
    }
    static const solid::Part& part() {
        static std::vector<std::optional<solid::Part>> made(cases().size());
        std::optional<solid::Part>& part = made[GetParam()];
        if (!part) part = solid::build_part(working(chosen().cam), chosen().options).value();
        return *part;
    }
    static Subject subject(const TitleOptions& title = {}) {
        static const spring::BaseSpring spring{spring::BaseKind::kTorsion, 0.0183, 3.7};
        static const checks::Cable cable;
        static const checks::Process process;
        return {part(),
                spring,
                cable,
                process,
                "a_design_with_a_name_of_some_length",
                "k_se_mirrored",
                "fusee 0.1.0, a_design_with_a_name_of_some_length, profile 0123456789ab, via=cgal, mirrored",
                title};
    }
    static std::vector<Sheet> sheets() { return draw(subject()); }
};

bool says(const std::vector<Sheet>& sheets, const std::string& words) {
    return std::any_of(sheets.begin(), sheets.end(), [&](const Sheet& sheet) {
        return std::any_of(sheet.texts.begin(), sheet.texts.end(), [&](const Text& t) { return t.words.find(words) != std::string::npos; });
    });
}

TEST_P(Drawn, NoTextOverlapsAnotherOrALine) {
    for (const Sheet& sheet : sheets())
        for (std::size_t i = 0; i < sheet.texts.size(); ++i) {
            const Box box = box_of(sheet.texts[i]);
            for (std::size_t k = 0; k < i; ++k)
                EXPECT_FALSE(box.overlaps(box_of(sheet.texts[k]))) << sheet.texts[i].words << " / " << sheet.texts[k].words;
            for (const Stroke& stroke : sheet.strokes)
                for (std::size_t k = stroke.closed ? 0 : 1; k < stroke.line.size(); ++k) {
                    const Point &a = stroke.line[(k + stroke.line.size() - 1) % stroke.line.size()], &b = stroke.line[k];
                    EXPECT_FALSE(box.meets(a, b)) << sheet.texts[i].words << " at " << box.low[0] << ", " << box.low[1];
                }
        }
}

TEST_P(Drawn, NothingFallsOffTheFrame) {
    for (const Sheet& sheet : sheets()) {
        const auto inside = [](const Point& p) { return Sheet::kFrame.holds({p, p}); };
        for (const Text& text : sheet.texts) EXPECT_TRUE(Sheet::kFrame.holds(box_of(text))) << text.words;
        for (const Arrow& arrow : sheet.arrows) EXPECT_TRUE(inside(arrow.tip));
        for (const Stroke& stroke : sheet.strokes) EXPECT_TRUE(std::all_of(stroke.line.begin(), stroke.line.end(), inside));
    }
}

TEST_P(Drawn, EveryRadiusArmAndLengthOfThePartIsOnIt) {
    const auto drawn = sheets();
    for (const FloorPoint& p : inspect_floor(part(), core::rad_from_deg(10.0)))
        EXPECT_TRUE(says(drawn, fmt::format("{:.3f}", core::mm_from_m(p.radius)))) << p.angle;
    for (const cam::Contact* row : {&part().cam.working.front(), &part().cam.working.back()}) {
        EXPECT_TRUE(says(drawn, fmt::format("{:.3f}", core::mm_from_m(row->arm.arm))));
        EXPECT_TRUE(says(drawn, fmt::format("{:.4f}", row->arm.arm * row->arm.tension)));
    }
    EXPECT_TRUE(part().cam.has_roller() ||
                says(drawn, fmt::format("{:.2f} mm on the working", core::mm_from_m(cable_length(part().cam).working))));
}

std::size_t strokes_of(const Sheet& sheet, const std::string& role) {
    return static_cast<std::size_t>(
        std::count_if(sheet.strokes.begin(), sheet.strokes.end(), [&role](const Stroke& s) { return s.role == role; }));
}

TEST_P(Drawn, DatumsTolerancesAndMarksAreThere) {
    const auto drawn = sheets();
    const Sheet& first = drawn.front();
    // Triangle with its stem, and the box of the letter, of A and B each.
    EXPECT_EQ(strokes_of(first, "datum"), 2u * 3u);
    EXPECT_GE(strokes_of(first, "line-profile"), 1u);
    EXPECT_EQ(strokes_of(first, "perpendicularity"), 2u + 3u) << "one frame of three cells";
    EXPECT_EQ(strokes_of(first, "run-out"), 1u + 3u);
    EXPECT_GE(strokes_of(first, "position"), 2u * 5u) << "key and mark";
    EXPECT_GE(strokes_of(first, "roughness"), 3u) << "in general, bore, floor";
    EXPECT_EQ(strokes_of(first, "edge-state"), 2u);
    EXPECT_EQ(strokes_of(first, "cable-exit"), part().cam.has_roller() ? 0u : 1u);
    const bool on_arm = part().cam.options.roller.follower == cam::FollowerKind::kArm;
    EXPECT_EQ(strokes_of(first, "follower-arm"), on_arm ? 1u : 0u);
    EXPECT_EQ(svg(first).find("pivot at x -60, y 0") != std::string::npos, on_arm);
    EXPECT_EQ(strokes_of(first, "turn"), 1u);
    EXPECT_EQ(strokes_of(first, "arc-end"), 2u);
    EXPECT_GT(strokes_of(first, "isometric"), 5u);
    const std::string text = svg(first);
    EXPECT_NE(text.find("class=\"thin line-profile\""), std::string::npos);
    for (const char* word : {">A<", ">B<", ">P<", ">Q<", ">0.6<", ">0.3<", "Ra 12.5", "PLA (ISO 1043-1), as printed", "ISO 2768-1 c"})
        EXPECT_NE(text.find(word), std::string::npos) << word;
}

/// Each triangle of a datum stands on a line: under the bore's size, or of its feature's frame.
TEST_P(Drawn, DatumsStandOnALine) {
    const auto drawn = sheets();
    const auto& strokes = drawn.front().strokes;
    std::size_t standing = 0;
    for (const Stroke& datum : strokes) {
        if (std::string(datum.role) != "datum" || datum.line.size() != 3) continue;
        const Point &a = datum.line[0], &b = datum.line[1];
        standing += std::any_of(strokes.begin(), strokes.end(), [&](const Stroke& s) {
            if (&s == &datum || std::string(s.role) == "datum") return false;
            const Box box{{std::min(s.line.front()[0], s.line.back()[0]), s.line.back()[1]},
                          {std::max(s.line.front()[0], s.line.back()[0]), s.line.back()[1]}};
            const bool shelf = s.line.size() == 2 && s.line[0][1] == s.line[1][1] && box.low[0] <= a[0] && b[0] <= box.high[0];
            const bool frame = s.closed && s.line.size() == 4;
            const double foot = frame ? s.line[2][1] : box.low[1];
            return (shelf || (frame && s.line[0][0] <= a[0] && a[0] <= s.line[1][0])) && std::abs(foot - a[1]) < 1e-9;
        });
    }
    EXPECT_EQ(standing, 2u);
}

TEST_P(Drawn, AKeywayHasOneFitAndADepthWithItsDeviation) {
    EXPECT_FALSE(says(sheets(), "JS9"));
    if (part().options.hub.lock != solid::HubLock::kKeyway) {
        EXPECT_FALSE(says(sheets(), "t2 "));
        return;
    }
    EXPECT_TRUE(says(sheets(), fmt::format("b {:g} \u00b10.3", core::mm_from_m(part().options.hub.key_width)))) << "as fdm leaves it";
    EXPECT_TRUE(says(sheets(), fmt::format("t2 {:g} +0.3/0", core::mm_from_m(part().options.hub.key_depth))));
    solid::Part filed = part();
    filed.options.hub.key_fit = solid::KeyFit::kByHand;
    const Subject of = subject();
    const auto drawn = draw({filed, of.spring, of.cable, of.process, of.design, of.name, of.provenance, of.title});
    EXPECT_TRUE(says(drawn, "fitted by hand"));
    EXPECT_TRUE(says(drawn, fmt::format("t2 {:g} +0.1/0", core::mm_from_m(part().options.hub.key_depth))));
}

/// The note goes from P to Q as the rows do.
TEST_P(Drawn, TheWorkingArcGoesFromPToQ) {
    const auto rows = check_rows(part(), 2);
    const auto deg = [](double angle) {
        return part().cam.closed() ? core::deg_from_rad(core::within_turn(angle, 0.0)) : core::deg_from_rad(angle);
    };
    std::string note;
    const auto drawn = sheets();
    for (const Text& text : drawn.front().texts) note += text.words + " ";
    const std::string begin = fmt::format("working arc, {:.1f}", deg(rows.front().angle));
    EXPECT_NE(note.find(begin.substr(0, begin.size() - 2)), std::string::npos) << begin;
}

TEST_P(Drawn, AHelixHasItsDevelopmentWithAScale) {
    EXPECT_EQ(says(sheets(), "development of the groove's centreline"), !part().cam.closed());
    EXPECT_EQ(strokes_of(sheets()[1], "development"), part().cam.closed() ? 0u : 2u);
}

/// Below the axis a counter-clockwise turn goes to the right.
TEST_P(Drawn, TheTurnHasTheSenseOfThePart) {
    const auto drawn = sheets();
    const auto& strokes = drawn.front().strokes;
    const auto turn = std::find_if(strokes.begin(), strokes.end(), [](const Stroke& s) { return std::string(s.role) == "turn"; });
    ASSERT_NE(turn, strokes.end());
    EXPECT_EQ(turn->line.back()[0] > turn->line.front()[0], part().cam.rotation_sign > 0);
}

TEST_P(Drawn, CheckRowsAndTheInspectionSheetAgree) {
    const auto drawn = sheets();
    const auto rows = check_rows(part());
    const coupon::InspectionSheet sheet = inspection_sheet(subject());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (const double length : {rows[i].x, rows[i].y, rows[i].radius, rows[i].arm})
            EXPECT_TRUE(says(drawn, fmt::format("{:.3f}", core::mm_from_m(length)))) << i;
        EXPECT_TRUE(part().cam.has_roller() || says(drawn, fmt::format("{:.3f}", std::cos(rows[i].tilt())))) << i;
        EXPECT_EQ(sheet.rows[i].x, rows[i].x);
        EXPECT_EQ(sheet.rows[i].nominal, rows[i].arm);
        EXPECT_NEAR(sheet.rows[i].high, 0.3e-3, 1e-12) << "what fdm holds, as the frame of 0.6";
        EXPECT_TRUE(std::isnan(sheet.rows[i].deviation));
    }
    EXPECT_EQ(sheet.part, "k_se_mirrored");
    EXPECT_GT(sheet.rows.size(), rows.size()) << "bore and face";
}

TEST_P(Drawn, TheSameBytesTwiceAndOnTwoThreads) {
    part();  // before there are two threads: the fixture is made on first use
    const auto make = [] { return svg(sheets().front()); };
    const auto print = [] { return pdf(sheets()); };
    auto other = std::async(std::launch::async, print);
    EXPECT_EQ(make(), make());
    const std::string bytes = print();
    EXPECT_EQ(bytes, other.get());
    EXPECT_TRUE(bytes.starts_with("%PDF-"));
    EXPECT_EQ(bytes.find("CreationDate"), std::string::npos);
    EXPECT_NE(bytes.find(fmt::format("/Count {}", sheets().size())), std::string::npos);
}

TEST_P(Drawn, TitleFieldsAreTheProfiles) {
    const TitleOptions title{"a legal owner with a rather long name 123", "4711", "C", "2026-11-23", "A. Maker", "B. Checker"};
    const auto filled = draw(subject(title));
    for (const char* words :
         {"a legal owner with a rather long name 123", "4711-k_se_mirrored", "C", "2026-11-23", "A. Maker", "B. Checker"})
        EXPECT_TRUE(says(filled, words)) << words;
    EXPECT_FALSE(says(filled, "Not stated"));
    EXPECT_TRUE(says(sheets(), "Not stated in the profile"));
    for (const Text& text : filled.front().texts) EXPECT_TRUE(Sheet::kFrame.holds(box_of(text))) << text.words;
}

INSTANTIATE_TEST_SUITE_P(Parts, Drawn, testing::Range<std::size_t>(0, 10),
                         [](const auto& chosen) { return std::string(cases()[chosen.param].name); });

// The sheet of a stack shows what its plates' drawings cut.
TEST(Stack, IsDrawnAsItIsCut) {
    solid::PartOptions options = fixtures::keyed_options();
    options.groove.stacked = true;
    options.groove.rib = options.features.leg_slot_depth = 1.5e-3;
    options.groove.plate = 1.2e-3;
    const solid::Part part = solid::build_part(working(fixtures::planar_cam()), options).value();
    const spring::BaseSpring spring{spring::BaseKind::kTorsion, 0.0183, 3.7};
    const checks::Cable cable;
    checks::Process process;
    process.kind = checks::ProcessKind::kLaser;
    const auto drawn = draw({part, spring, cable, process, "design", "k_se", "fusee"});
    for (const char* words : {"plates 1 and 3, each 1.5", "edge of plate 2, 1.2 thick", "2 dowel holes", "plates 2 and 3,",
                              "plate 3, its middle", "k_se_plate_1.dxf", "scribed on plate 3"})
        EXPECT_TRUE(says(drawn, words)) << words;
    for (const char* words : {"throat", "floor R", " deep"}) EXPECT_FALSE(says(drawn, words)) << words;
    EXPECT_TRUE(says(drawn, "4.2")) << "the height of all three";
}

using SheetFiles = fixtures::FolderTest;

TEST_F(SheetFiles, AreNumberedFromTheSecondOn) {
    const auto written = write_svg(folder_ / "k_pe_drawing", std::vector<Sheet>(3));
    ASSERT_EQ(written.size(), 3u);
    EXPECT_EQ(written[0].filename(), "k_pe_drawing.svg");
    EXPECT_EQ(written[2].filename(), "k_pe_drawing_3.svg");
    EXPECT_EQ(core::read_file(written[1]), svg(Sheet{}));
}

}  // namespace
}  // namespace fusee::drawing
