#include <algorithm>
#include <cmath>

#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "toolpath/fixture.h"

namespace fusee::toolpath {
namespace {

/// One terrace and one pass a plate, so that a program is short: the start of the ring is at psi = pi.
Settings few_moves() {
    Settings settings;
    settings.terrace = settings.depth_per_pass = 10e-3;
    settings.feed = 300.0 / 60e3;
    settings.plunge_feed = 100.0 / 60e3;
    settings.dowel_diameter = 0.0;
    return settings;
}
solid::Part round_disc() {
    cam::Cam cam = fixtures::planar_cam(12e-3, 0.0);
    cam.working_psi = {-1.25, 1.25};
    return part_of(cam);
}

void expect_words(const Words& found, const Words& wanted) {
    for (const auto& [letter, value] : wanted) {
        ASSERT_TRUE(found.contains(letter)) << letter;
        EXPECT_NEAR(found.at(letter), value, 1e-5) << letter;  // five places are printed
    }
}

// Floor radius 12 - 0.5 mm, cutter 3 mm: the contour itself is programmed; in and out on quarter circles of 3 mm, entered by a line of 3
// mm.
TEST(Contour, MovesOfARoundDiscAreKnownByHand) {
    const auto program = contour_program(round_disc(), few_moves(), "test");
    ASSERT_TRUE(program);
    const std::vector<Words> lines = lines_of(program->text);
    const auto first = std::find_if(lines.begin(), lines.end(), [](const Words& w) {
        return w.contains('G') && w.contains('D') == false && w.contains('Y') && w.at('Y') < -2.9;
    });
    ASSERT_LT(first - lines.begin() + 53, static_cast<long>(lines.size()));
    expect_words(first[0], {{'G', 0}, {'X', -17.5}, {'Y', -3}});
    expect_words(first[1], {{'G', 1}, {'F', 100}});
    EXPECT_NEAR(first[1].at('Z'), -round_disc().section.back().z_mm, 1e-5);
    expect_words(first[2], {{'G', 1}, {'X', -14.5}, {'Y', -3}, {'F', 300}});
    expect_words(first[3], {{'G', 3}, {'X', -11.5}, {'Y', 0}, {'I', 0}, {'J', 3}});
    const double step = core::kPi / 24;  // 24 pairs of arcs, clockwise from psi = pi
    for (int i = 1; i <= 48; ++i) {
        const double psi = core::kPi - step * i, before = psi + step;
        expect_words(first[3 + i], {{'G', 2},
                                    {'X', 11.5 * std::cos(psi)},
                                    {'Y', 11.5 * std::sin(psi)},
                                    {'I', -11.5 * std::cos(before)},
                                    {'J', -11.5 * std::sin(before)}});
    }
    expect_words(first[52], {{'G', 3}, {'X', -14.5}, {'Y', 3}, {'I', -3}, {'J', 0}});
    expect_words(first[53], {{'G', 1}, {'X', -17.5}, {'Y', 3}});
}

TEST(Contour, EqualInputGivesEqualBytes) {
    EXPECT_EQ(contour_program(disc(), {}, "test")->text, contour_program(disc(), {}, "test")->text);
}

TEST(Contour, ACutterWiderThanTheBoreIsRefusedWithOneThatFits) {
    Settings settings;
    settings.tool_diameter = 6e-3;  // the bore has 5.2 mm
    for (const auto& program : {contour_program(disc(), settings, "test"), blank_program(disc(), settings, "test")}) {
        ASSERT_FALSE(program);
        const core::Finding& finding = program.refusal().front();
        EXPECT_EQ(finding.rule, "toolpath.bore");
        EXPECT_NEAR(finding.measured, 6.0, 1e-9);
        EXPECT_NE(finding.suggestion.text().find("machining.tool_diameter_mm = 4.9"), std::string::npos) << finding.suggestion.text();
    }
    settings.tool_diameter = 4.9e-3;
    EXPECT_TRUE(contour_program(disc(), settings, "test"));
}

TEST(Contour, AHelixIsNotStacked) {
    try {
        (void)contour_program(helix(), {}, "test");
        ADD_FAILURE();
    } catch (const core::InvalidInput& error) {
        EXPECT_EQ(error.field(), "k_pe.path.kind");
    }
}

TEST(Contour, EveryPartGetsThePrograms) {
    const auto suffixes = [](const solid::Part& part, Method k_se) {
        Settings settings;
        settings.k_se = k_se;
        std::vector<std::string> names;
        const auto programs = part_programs(part, settings, "test");
        for (const Program& program : *programs) names.push_back(program.suffix);
        return names;
    };
    using Names = std::vector<std::string>;
    EXPECT_EQ(suffixes(disc(), Method::kStack), (Names{""}));
    EXPECT_EQ(suffixes(disc(), Method::kWrap), (Names{"_blank", ""}));
    EXPECT_EQ(suffixes(helix(), Method::kStack), (Names{""}));
    const solid::Part boss = part_of(fixtures::planar_cam(), fixtures::overhung_options());
    EXPECT_EQ(suffixes(boss, Method::kStack), (Names{"", "_boss"}));
}

using ContourInterpreted = InterpreterTest;

// What the controller makes of it: the cutter's centre 1.5 mm outside the contour.
TEST_F(ContourInterpreted, CompensationHoldsTheCutterOffTheContour) {
    const Interpreted program = run(contour_program(round_disc(), few_moves(), "test")->text);
    EXPECT_TRUE(faults(program).empty()) << faults(program).front();
    double nearest = 1e9;
    for (const Move& move : program.moves)
        if (const double r = std::hypot(move.to.x, move.to.y); !move.rapid && move.to.z < -0.01 && r > 5.0) nearest = std::min(nearest, r);
    EXPECT_NEAR(nearest, 13.0, 2e-4);  // chords 5e-5, four printed places
}

}  // namespace
}  // namespace fusee::toolpath
