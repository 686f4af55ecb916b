#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <regex>

#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "fusee/solid/cutters.h"
#include "fusee/toolpath/mill.h"
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
    ASSERT_LT(first - lines.begin() + 54, static_cast<long>(lines.size()));
    expect_words(first[0], {{'G', 0}, {'X', -17.5}, {'Y', -3}});
    expect_words(first[1], {{'G', 0}, {'Z', 1}});
    expect_words(first[2], {{'G', 1}, {'F', 100}});
    EXPECT_NEAR(first[2].at('Z'), -round_disc().section.back().z_mm, 1e-5);
    expect_words(first[3], {{'G', 1}, {'X', -14.5}, {'Y', -3}, {'F', 300}});
    expect_words(first[4], {{'G', 3}, {'X', -11.5}, {'Y', 0}, {'I', 0}, {'J', 3}});
    const double step = core::kPi / 24;  // 24 pairs of arcs, clockwise from psi = pi
    for (int i = 1; i <= 48; ++i) {
        const double psi = core::kPi - step * i, before = psi + step;
        expect_words(first[4 + i], {{'G', 2},
                                    {'X', 11.5 * std::cos(psi)},
                                    {'Y', 11.5 * std::sin(psi)},
                                    {'I', -11.5 * std::cos(before)},
                                    {'J', -11.5 * std::sin(before)}});
    }
    expect_words(first[53], {{'G', 3}, {'X', -14.5}, {'Y', 3}, {'I', -3}, {'J', 0}});
    expect_words(first[54], {{'G', 1}, {'X', -17.5}, {'Y', 3}});
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

/// What the simulated mill finds in the programs of a part, the blank's stock carried into the groove's set-up.
std::vector<mill::Contact> contacts_of(
    const solid::Part& part, const Settings& settings,
    const std::function<std::string(std::string)>& plant = [](std::string text) { return text; }) {
    std::vector<mill::Contact> all;
    std::optional<mill::Stock> blank;
    const std::vector<Program> programs = part_programs(part, settings, "test").value();
    for (const Program& program : programs) {
        const bool wraps = program.text.find("(cuts wrap)") != std::string::npos;
        mill::Result result = mill::simulate(mill::read_program(plant(program.text), program.suffix), 0.2,
                                             wraps && blank ? &*blank : nullptr, core::mm_from_m(part.z_high));
        all.insert(all.end(), result.contacts.begin(), result.contacts.end());
        blank = mill::released(std::move(result.stock), core::mm_from_m(settings.tab_height));
    }
    return all;
}

bool finds(const std::vector<mill::Contact>& contacts, const std::string& rule) {
    return std::any_of(contacts.begin(), contacts.end(), [&](const mill::Contact& c) { return c.rule == rule; });
}

/// Rough and quick.
Settings wrapped(int tabs = 3) {
    Settings settings;
    settings.k_se = settings.k_pe = Method::kWrap;
    settings.depth_per_pass = settings.terrace = 1e-3;
    settings.wrap_depth = 1e-3;
    settings.dowel_diameter = 1e-3;
    settings.tabs = tabs;
    return settings;
}

TEST(Contour, ProgramsPassTheSimulatedMill) {
    const solid::Part boss = part_of(fixtures::planar_cam(), fixtures::overhung_options());
    Settings stacked = wrapped();
    stacked.k_se = stacked.k_pe = Method::kStack;
    for (const auto& contacts : {contacts_of(disc(), wrapped()), contacts_of(disc(), stacked), contacts_of(boss, wrapped(3)),
                                 contacts_of(boss, wrapped(0)), contacts_of(boss, stacked)})
        EXPECT_TRUE(contacts.empty()) << contacts.front().rule << ": " << contacts.front().what << ", line " << contacts.front().line;
}

// A disc of the stated diameter is as long as it is wide: no strips for clamps, which a sheet has.
TEST(Contour, ATurnedBlankHasNoStripsForClamps) {
    const solid::Part boss = part_of(fixtures::planar_cam(), fixtures::overhung_options());
    const std::string text = blank_program(boss, wrapped(), "test")->text;
    std::smatch stock, disc;
    ASSERT_TRUE(std::regex_search(text, stock, std::regex("stock box (\\S+) (\\S+) (\\S+) (\\S+)")));
    ASSERT_TRUE(std::regex_search(text, disc, std::regex("disc of at least (\\S+) mm")));
    for (std::size_t i = 1; i <= 4; ++i) EXPECT_NEAR(std::abs(std::stod(stock[i].str())), 0.5 * std::stod(disc[1].str()), 1e-3) << i;
}

// The same two places in the G-code, in the solid and in its mirror image.
TEST(Contour, TheDowelsAreHolesOfTheSolid) {
    Settings settings = wrapped();
    settings.k_se = settings.k_pe = Method::kStack;
    solid::PartOptions options = disc().options;
    options.dowel_diameter = settings.dowel_diameter;
    const solid::Part part = solid::build_part(disc().cam, options).value();
    const std::string text = contour_program(part, settings, "test")->text;
    const solid::Part whole = solid::build_part(disc().cam, disc().options).value();
    EXPECT_LT(solid::volume_mm3(part.mesh), solid::volume_mm3(whole.mesh) - 1.0) << "two holes of 1 mm through more than 1 mm";
    const auto dowels_of = [](const solid::Part& of) {
        std::vector<solid::Cutter> cutters = solid::make_cutters(of);
        std::erase_if(cutters, [](const solid::Cutter& c) { return c.name != "dowel"; });
        return cutters;
    };
    const auto here = dowels_of(part), image = dowels_of(solid::mirrored(part));
    ASSERT_EQ(here.size(), 2U);
    ASSERT_EQ(image.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        const auto [x, y] = here[i].outline.front().centre_mm;
        EXPECT_NE(text.find(fmt::format("{:.3f} {:.3f}", x, y)), std::string::npos) << x << " " << y;
        EXPECT_NEAR(image[i].outline.front().centre_mm[0], x, 1e-9);
        EXPECT_NEAR(image[i].outline.front().centre_mm[1], -y, 1e-9);
    }
    EXPECT_TRUE(dowels_of(disc()).empty()) << "one piece";
}

/// The drill of a blind hole makes no room for the reamer's lead, 0.25 mm.
std::string without_room(std::string text) {
    const std::size_t reamer = text.find("(T3: reamer"), drilled = text.rfind("G1 Z-", reamer);
    if (reamer == std::string::npos) return text;
    const std::string deepest = text.substr(drilled, text.find(' ', drilled + 3) - drilled);
    return replaced(text, deepest, fmt::format("G1 Z{:.5f}", std::stod(deepest.substr(4)) + 0.25));
}

// Each program with the fault that it had, or could have.
TEST(Contour, OldFaultsAreCaughtByTheSimulatedMill) {
    Settings stacked = wrapped();
    stacked.k_se = stacked.k_pe = Method::kStack;
    const auto spoiled = [](const std::string& from, const std::string& to) {
        return [from, to](const std::string& text) { return std::regex_replace(text, std::regex(from), to); };
    };
    EXPECT_TRUE(finds(contacts_of(disc(), stacked, spoiled("G0 Z15.00000", "G0 Z5.00000")), "millsim.safe_height"));
    EXPECT_TRUE(finds(contacts_of(disc(), stacked, spoiled("(S[0-9]* M3\n)", "$1G0 Z15\n")), "millsim.approach"));
    EXPECT_TRUE(finds(contacts_of(disc(), stacked, spoiled("G53 G0 Z0", "")), "millsim.tool_change"));
    EXPECT_TRUE(finds(contacts_of(disc(), stacked, spoiled(" G91.1", "")), "millsim.arc_mode"));
    EXPECT_TRUE(finds(contacts_of(disc(), wrapped(), spoiled("\\(index [^)]*\\)", "")), "millsim.index"));
    EXPECT_TRUE(finds(contacts_of(disc(), wrapped(), spoiled("there A is [-0-9]*", "there A is 7")), "millsim.index"));
    EXPECT_TRUE(finds(contacts_of(disc(), stacked, spoiled("G43 H[0-9]", "")), "millsim.tool_length"));
    EXPECT_TRUE(finds(contacts_of(disc(), stacked, spoiled("H1", "H2")), "millsim.tool_length"));
    EXPECT_TRUE(finds(contacts_of(disc(), stacked, spoiled("M3\n", "\n")), "millsim.spindle"));
    EXPECT_TRUE(finds(contacts_of(disc(), wrapped(), without_room), "millsim.reamer"));
    // Nothing holds the plates of a sheet without tabs.
    EXPECT_TRUE(finds(contacts_of(disc(), stacked, spoiled("G1 Z-[0-9.]* F[0-9.]*\nG2", "G2")), "millsim.free"));
    // The reamer stops where its tip is through.
    const auto down = [](double depth) { return fmt::format("G1 Z-{:.5f} ", depth); };
    const double through = core::mm_from_m(-disc().z_low) + 0.3;
    EXPECT_TRUE(finds(contacts_of(disc(), stacked, spoiled(down(through + 0.25), down(through - 0.25))), "millsim.hole"));
    // The ring of a turned blank without the skin.
    const solid::Part boss = part_of(fixtures::planar_cam(), fixtures::overhung_options());
    const double thick = core::mm_from_m(boss.z_high - boss.z_low);
    EXPECT_TRUE(finds(contacts_of(boss, wrapped(0), spoiled(down(thick - 0.5), down(thick + 0.01))), "millsim.free"));
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
