#include "exchange/fixtures/expect_refusal.h"
#include "fusee/core/units.h"
#include "toolpath/fixture.h"

namespace fusee::toolpath {
namespace {

/// Largest distance, along rays from the axis, between the floor that a program leaves and the one drawn [mm].
double floor_error(const CutFloor& cut, const cam::Cam& cam) {
    double worst = 0.0;
    const core::Range range = cam.closed() ? cam.groove_psi : cam.working_psi;
    for (double psi = range.low; psi < range.high; psi += 0.0101) {
        const cam::PathPoint p = cam.path(psi);
        const double half = 0.5 * cam.options.cable_diameter, x = 1e3 * (p.x() - half * std::cos(psi)),
                     y = 1e3 * (p.y() - half * std::sin(psi));
        const auto radius = cut.radius(std::atan2(y, x), 1e3 * p.z);
        worst = std::max(worst, radius ? std::abs(*radius - std::hypot(x, y)) : 1e9);
    }
    return worst;
}

using ReadBack = InterpreterTest;

// Tolerance 1e-3, printed places 1e-4, chords of arcs and turns 1e-4: the sum is allowed.
constexpr double kAllowed_mm = 1.2e-3;

TEST_F(ReadBack, BothHalfPlatesLeaveTheFloor) {
    const Interpreted program = run(contour_program(disc(), {}, "test")->text);
    EXPECT_TRUE(faults(program).empty()) << faults(program).front();
    const auto floors = cut_floors(program);
    ASSERT_EQ(floors.size(), 2u);
    EXPECT_EQ(floors[0].name(), "lower");
    EXPECT_EQ(floors[1].name(), "upper");
    for (const CutFloor& floor : floors) EXPECT_LE(floor_error(floor, disc().cam), kAllowed_mm) << floor.name();
}

TEST_F(ReadBack, WrappedGroovesLeaveTheFloor) {
    for (const int sign : {1, -1})
        for (const solid::Part& part : {disc(), helix()}) {
            Settings settings;
            settings.rotary_sign = sign;
            const Interpreted program = run(wrap_program(part, settings, "test").text);
            EXPECT_TRUE(faults(program).empty()) << faults(program).front();
            const auto floors = cut_floors(program);
            ASSERT_EQ(floors.size(), 1u);
            EXPECT_LE(floor_error(floors[0], part.cam), kAllowed_mm);
        }
}

TEST_F(ReadBack, BlankAndBossLeaveNoFloorAndAreSafe) {
    const solid::Part part = part_of(fixtures::planar_cam(12e-3, 4e-3), fixtures::overhung_options());
    for (const auto& program : {blank_program(part, {}, "test"), boss_program(part, {}, "test")}) {
        ASSERT_TRUE(program);
        const Interpreted moves = run(program->text);
        EXPECT_TRUE(faults(moves).empty()) << faults(moves).front();
        EXPECT_TRUE(cut_floors(moves).empty());
    }
}

TEST_F(ReadBack, FollowsTheCompensatedPath) {
    const std::string text = contour_program(disc(), {}, "test")->text;
    const auto uncompensated = cut_floors(run(replaced(text, "G41.1 D#<cutter> ", "")));
    EXPECT_NEAR(floor_error(uncompensated[0], disc().cam), 1.5, 0.1);  // the radius, seen along a ray
    const auto worn = cut_floors(run(replaced(text, "#<cutter> = 3.00000", "#<cutter> = 2.98000")));
    EXPECT_NEAR(floor_error(worn[0], disc().cam), 0.01, 1.5e-3);  // for a cutter that is not worn: 0.01 mm too deep
}

TEST_F(ReadBack, ATurnTheWrongWayIsSeen) {
    const std::string text = wrap_program(disc(), {}, "test").text;
    EXPECT_GT(floor_error(cut_floors(run(replaced(text, "(rotary 1)", "(rotary -1)")))[0], disc().cam), 0.1);
}

TEST_F(ReadBack, ARapidInStockIsSeenWhenTheSafeHeightIsSpoiled) {
    const auto spoiled = faults(run(replaced(contour_program(disc(), {}, "test")->text, "G0 Z1.00000", "G0 Z-0.20000")));
    ASSERT_FALSE(spoiled.empty());
    EXPECT_NE(spoiled.front().find("passes through the stock"), std::string::npos);
    const solid::Part part = disc();
    Settings settings;
    settings.safe_height = 1e-3;
    const std::string text = wrap_program(part, settings, "test").text;
    const std::size_t at = text.find("\nG0 Z") + 1;
    const std::string clear = text.substr(at + 3, text.find('\n', at) - at - 3);
    EXPECT_TRUE(faults(run(text)).empty());
    EXPECT_FALSE(faults(run(replaced(text, clear, "Z13.00000"))).empty());
}

TEST(ReadBackWords, AProgramOfSomebodyElseIsAnError) {
    const Interpreted foreign = parse_canonical("1 N..... STRAIGHT_TRAVERSE(1.0, 0.0, 5.0, 0.0, 0.0, 0.0)\n", "foreign.ngc");
    fixtures::expect_refusal([&] { (void)cut_floors(foreign); }, {"foreign.ngc", "cuts"});
}

}  // namespace
}  // namespace fusee::toolpath
