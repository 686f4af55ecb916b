#include "fusee/toolpath/mill.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "fusee/core/error.h"
#include "fusee/core/units.h"

namespace fusee::toolpath::mill {
namespace {

/// A pocket of 2 mm depth in a plate of 3 mm: cutter 4 mm, flutes 5 mm, stick-out 20 mm; a clamp over the plate's end.
const char* const kGood = R"((stock box 0 40 0 20 -3 0)
(board -3 0.3) (clamp box -10 0.5 0 20 10)
(tool 1 end 4 5 4 20 19)
G21 G90 G94 G91.1
G53 G0 Z0
T1 M6
G43 H1 S1000 M3
G0 X10 Y10
G0 Z5
G1 Z-1 F100
G1 X30
G1 Z-2
G1 X10
G1 Z5
M2
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

Result run(const std::string& text, double cell = 0.1) { return simulate(read_program(text, "a.ngc"), cell); }

/// The contact of a rule, if the program has one.
std::optional<Contact> contact(const std::string& text, const std::string& rule) {
    const Result result = run(text);
    const auto found = std::find_if(result.contacts.begin(), result.contacts.end(), [&](const Contact& c) { return c.rule == rule; });
    return found == result.contacts.end() ? std::nullopt : std::optional(*found);
}

TEST(Millsim, AGoodProgramLeavesTheSlotAndNoContact) {
    const Result result = run(kGood);
    EXPECT_TRUE(result.contacts.empty()) << result.contacts.front().what;
    EXPECT_NEAR(*result.stock.top(20.05, 10.05), -2.0, 1e-12);
    EXPECT_NEAR(*result.stock.top(20.05, 11.85), -2.0, 1e-12);  // the radius is 2 mm
    EXPECT_EQ(*result.stock.top(20.05, 12.15), 0.0);
    EXPECT_NEAR(*result.stock.top(31.85, 10.05), -2.0, 1e-12);
    EXPECT_NEAR(result.minutes, (6.0 + 20.0 + 1.0 + 20.0 + 7.0) / 100.0 + 95.0 / 3000.0, 1e-9);
    EXPECT_TRUE(contact_findings(result, "a.ngc").empty());
}

TEST(Millsim, ARapidThroughStockIsFoundWithItsLine) {
    const auto found = contact(replaced(kGood, "G1 X30\n", "G0 X30\nG1\n"), "millsim.rapid");
    ASSERT_TRUE(found);
    EXPECT_EQ(found->line, 11u);
    EXPECT_NEAR(found->measured, 1.0, 1e-9);
}

TEST(Millsim, AShortStickOutIsFound) {
    const auto found = contact(replaced(kGood, "4 5 4 20 19", "4 1 4 1.5 19"), "millsim.holder");
    ASSERT_TRUE(found);
    EXPECT_EQ(found->line, 12u);  // at Z-2 the holder is 0.5 mm below the top
    EXPECT_NEAR(found->measured, 0.5, 1e-9);
    EXPECT_FALSE(contact(replaced(kGood, "4 5 4 20 19", "4 1 4 2.1 19"), "millsim.holder"));
}

TEST(Millsim, AThickShankAboveShortFlutesIsFound) {
    const auto found = contact(replaced(kGood, "4 5 4 20 19", "4 1.5 6 20 19"), "millsim.shank");
    ASSERT_TRUE(found);
    EXPECT_EQ(found->line, 12u);
    EXPECT_FALSE(contact(replaced(kGood, "4 5 4 20 19", "4 2.1 6 20 19"), "millsim.shank"));
}

TEST(Millsim, APlungeTooDeepIsFound) {
    const auto found = contact(replaced(kGood, "G1 Z-2", "G1 Z-4"), "millsim.board");
    ASSERT_TRUE(found);
    EXPECT_EQ(found->line, 12u);
    EXPECT_NEAR(found->measured, 0.7, 1e-9);
    EXPECT_FALSE(contact(replaced(kGood, "G1 Z-2", "G1 Z-3.3"), "millsim.board"));
}

TEST(Millsim, AClampInTheWayIsFound) {
    const auto cutter = contact(replaced(kGood, "G1 X10\n", "G1 X1\n"), "millsim.clamp");
    ASSERT_TRUE(cutter);
    EXPECT_EQ(cutter->line, 13u);
    // The holder reaches 9.5 mm to the side: with 10 mm of stick-out it is at Z8 in the slot, below the clamp's top.
    EXPECT_TRUE(contact(replaced(replaced(kGood, "G0 X10 Y10", "G0 X8 Y10"), "4 20 19", "4 10 19"), "millsim.clamp"));
    EXPECT_FALSE(contact(replaced(kGood, "G0 X10 Y10", "G0 X8 Y10"), "millsim.clamp"));
}

std::string twin(const char* from, const char* to) { return replaced(kGood, from, to); }

TEST(Millsim, AChangeOfToolWithoutARetractIsFound) {
    const auto first = contact(twin("G53 G0 Z0\n", "\n"), "millsim.tool_change");
    ASSERT_TRUE(first);
    EXPECT_EQ(first->line, 6u);
    // At the safe height, too: the next tool may be longer.
    const auto second = contact(twin("G1 Z5\nM2", "G1 Z15\nT1 M6"), "millsim.tool_change");
    ASSERT_TRUE(second);
    EXPECT_EQ(second->line, 15u);
    EXPECT_FALSE(contact(twin("G1 Z5\nM2", "G53 G0 Z0\nT1 M6"), "millsim.tool_change"));
}

TEST(Millsim, ZBeforeXAndYAfterAChangeOfToolIsFound) {
    for (const char* order : {"G0 Z5\nG0 X10 Y10", "G0 X10 Y10 Z5\n", "G0 X10 Z5\nG0 Y10"}) {
        const auto found = contact(twin("G0 X10 Y10\nG0 Z5", order), "millsim.approach");
        ASSERT_TRUE(found) << order;
        EXPECT_EQ(found->line, 8u) << order;
    }
}

TEST(Millsim, ARapidAcrossBelowTheClampsIsFound) {
    const auto found = contact(twin("G1 Z5\nM2", "G1 Z5\nG0 X20\nM2"), "millsim.safe_height");
    ASSERT_TRUE(found);
    EXPECT_EQ(found->line, 15u);
    EXPECT_NEAR(found->measured, 5.0, 1e-9);
    EXPECT_FALSE(contact(twin("G1 Z5\nM2", "G1 Z10.1\nG0 X20\nM2"), "millsim.safe_height"));
}

TEST(Millsim, AnArcWithoutTheModeOfItsCentreIsFound) {
    const auto found = contact(replaced(twin(" G91.1", ""), "G1 X10\n", "G3 X30 Y10 I-4 J0\n"), "millsim.arc_mode");
    ASSERT_TRUE(found);
    EXPECT_EQ(found->line, 13u);
    EXPECT_FALSE(contact(twin("G1 X10\n", "G3 X30 Y10 I-4 J0\n"), "millsim.arc_mode"));
}

/// A hole of 2 mm through a plate of 3 mm by a drill with a point of 0.6 mm: `depth` of its tip.
std::string drilled(const char* depth) {
    return replaced(
        R"((stock box 0 10 0 10 -3 0) (board -3 0.3) (held box 0 10 0 10)
(tool 2 cone 0 0.6 2 9 2 20 19)
(hole 5 5 2 -3)
G53 G0 Z0
T2 M6 G43 M3
G0 X5 Y5
G1 Z-DEPTH F100
G1 Z5
)",
        "DEPTH", depth);
}

TEST(Millsim, ADrillThatIsThroughWithItsPointOnlyIsFound) {
    const auto found = contact(drilled("3.3"), "millsim.hole");
    ASSERT_TRUE(found);
    EXPECT_EQ(found->line, 3u);
    EXPECT_NEAR(found->measured, 0.6 * 0.9 - 0.3, 0.07);  // at 0.9 mm from the axis, within a cell
    EXPECT_TRUE(run(drilled("3.7")).contacts.empty());
    EXPECT_NEAR(contact(drilled("4.1"), "millsim.board")->measured, 0.2, 1e-9);  // of its full diameter
}

// A blind hole is drilled 1 mm deep, its point 0.6 mm more: a reamer's end is 1.2 mm wide.
TEST(Millsim, AReamerThatMeetsTheBottomOfItsHoleIsFound) {
    const auto reamed = [](const char* depth) {
        return contact(
            drilled("1.6") + replaced("(tool 3 cone 1.2 0.4 2 9 2 20 19)\nG53 G0 Z0\nT3 M6 G43 M3\nG1 X5 Y5\nG1 ZDEPTH\n", "DEPTH", depth),
            "millsim.reamer");
    };
    const auto found = reamed("-1.6");
    ASSERT_TRUE(found);
    EXPECT_EQ(found->line, 13u);
    EXPECT_NEAR(found->measured, 0.6 * 0.6, 0.07);  // at 0.6 mm from the axis, within a cell
    EXPECT_FALSE(reamed("-1.2"));
}

/// A ring of 4 mm radius cut out of a plate: `bottom` of the cut.
std::string cut_out(const char* bottom) {
    return replaced(
        R"((stock box -9 9 -9 9 -3 0) (clamp box -20 -8 -9 9 1)
(tool 1 end 2 5 2 20 19)
G91.1 G53 G0 Z0
T1 M6 G43 M3
G0 X5 Y0
G1 ZBOTTOM F100
G3 X5 Y0 I-5 J0
G1 Z5
)",
        "BOTTOM", bottom);
}

TEST(Millsim, APieceThatIsCutFreeIsFound) {
    const auto found = contact(cut_out("-3.1"), "millsim.free");
    ASSERT_TRUE(found);
    EXPECT_EQ(found->line, 7u);
    EXPECT_NEAR(found->measured, core::kPi * 16.0, 1.0);
    EXPECT_FALSE(contact(cut_out("-2.5"), "millsim.free"));  // a skin holds it
    // Held in the middle, the ring of the stock around it falls.
    const auto ring = contact(replaced(cut_out("-3.1"), "clamp box -20 -8 -9 9 1", "held box -2 2 -2 2"), "millsim.free");
    ASSERT_TRUE(ring);
    EXPECT_NEAR(ring->measured, 18.0 * 18.0 - core::kPi * 36.0, 1.0);
}

// A ring of 5 mm radius, with a cutter of 2 mm on its left: the path has 6 mm.
TEST(Millsim, CompensationOffsetsArcsAndExpressionsAreRead) {
    const Program program =
        read_program("#<cutter> = 2\nG0 X-8 Y-3 Z5\nF100\nG41.1 D#<cutter> G1 X-8 Y-3\nG1 X-[2+3] Y-3\nG40 G1 X0 Y0\n", "a.ngc");
    EXPECT_NEAR(program.moves[2].to.y, -2.0, 1e-12);  // left of a move along +X
    const Program ring = read_program(
        "#<cutter> = 2\nG0 X-11 Y-3\nF100\nG41.1 D#<cutter> G1 X-8 Y-3\nG3 X-5 Y0 I0 J3\nG2 X-5 Y0 I5 J0\nG40 G1 X-5 Y9\n", "a.ngc");
    double nearest = 1e9, farthest = 0.0;
    for (const Move& move : ring.moves)
        if (move.line == 6) {
            nearest = std::min(nearest, std::hypot(move.to.x, move.to.y));
            farthest = std::max(farthest, std::hypot(move.to.x, move.to.y));
        }
    EXPECT_NEAR(nearest, 6.0, 1e-9);
    EXPECT_NEAR(farthest, 6.0, 1e-9);
}

TEST(Millsim, WhatIsNotUnderstoodIsRefusedWithItsLine) {
    for (const char* text :
         {"G21\nG5 X1\n", "G21\nG20\n", "G21\nX#<a>\n", "G21\nG1 X1 Y1\n", "G21\nW3\n", "G21\nX1e13\n", "G21\nX[1/0]\n",
          "G0 X1 Y0 F100\nG3 X1 Y0 I-1 P839899\n", "G0 X1 Y0 F100\nG3 X1 Y0 I-1 P0.5\n", "G0 X1 Y0 F100\nG3 X1 Y1 I-1e12\n"}) {
        try {
            (void)read_program(text, "a.ngc");
            ADD_FAILURE() << text;
        } catch (const core::IoError& error) {
            EXPECT_NE(std::string(error.what()).find("line 2"), std::string::npos) << error.what();
        }
    }
    EXPECT_THROW((void)run(replaced(kGood, "(tool 1", "(tol 1")), core::IoError);
    EXPECT_THROW((void)run(replaced(kGood, "stock", "stok")), core::IoError);
}

/// A round bar of 10 mm radius turned once below a nose of 1 mm radius at a depth of 2 mm.
const char* const kTurned = R"((stock round 10 -5 5)
(rotary 1)
(clamp round 8 -40 -20)
(tool 2 form 2 45 4 6 4 30 19)
G21 G90 G53 G0 Z0
T2 M6 G43 M3
G0 A0 X0 Y0
G0 Z15
G1 Z8 F100
G1 A-360 F1000
G1 Z15
M2
)";

TEST(Millsim, ARotaryGrooveHasTheCuttersSectionAllAround) {
    const Result result = run(kTurned, 0.2);
    EXPECT_TRUE(result.contacts.empty()) << result.contacts.front().what;
    for (int k = 0; k < 16; ++k) {
        const double angle = core::kPi * k / 8.0;
        const auto half = [&](double radius) {
            double least = 9.0;
            for (const auto& one : result.stock.at(radius * std::cos(angle), radius * std::sin(angle)))
                least = std::min(least, one[0] < 0.0 && one[1] > 0.0 ? 0.0 : std::min(std::abs(one[0]), std::abs(one[1])));
            return least;
        };
        EXPECT_EQ(half(7.7), 0.0);
        // 1.5 mm above the tip: sqrt(2)/2 + 1.5 - (1 - sqrt(2)/2), within a cell at 45 deg.
        EXPECT_NEAR(half(9.5), 1.914, 0.25);
    }
}

/// The turned bar's program upon a blank that is drilled 3 mm beside the axis. `index` says where.
std::optional<Contact> indexed(const std::string& index) {
    const Stock blank = run(R"((stock box -10 10 -10 10 -10 0) (held box -10 10 -10 10)
(tool 2 end 2 9 2 20 19)
G53 G0 Z0
T2 M6 G43 M3
G0 X0 Y3
G1 Z-4 F100
G1 Z5
)")
                            .stock;
    const Result result = simulate(read_program(index + kTurned, "a.ngc"), 0.2, &blank, 5.0);
    const auto found =
        std::find_if(result.contacts.begin(), result.contacts.end(), [](const Contact& c) { return c.rule == "millsim.index"; });
    return found == result.contacts.end() ? std::nullopt : std::optional(*found);
}

TEST(Millsim, ABlankWithoutAnIndexIsFound) {
    EXPECT_TRUE(indexed(""));
    EXPECT_FALSE(indexed("(index 0 3 2 1)\n(A: there A is 180)\n"));
    EXPECT_FALSE(indexed("(index none)\n"));
    EXPECT_NEAR(indexed("(index 3 0 2 1)\n(A: there A is -90)\n")->measured, 4.0, 1e-9);   // where the blank has none
    EXPECT_NEAR(indexed("(index 0 3 2 -1)\n(A: there A is 180)\n")->measured, 2.0, 1e-9);  // deeper than it is
}

// A pin that is set 1.91 deg beside its A, on the other side, or without any A.
TEST(Millsim, AnIndexThatIsNotWhereItsAIsFound) {
    EXPECT_NEAR(indexed("(index 0 3 2 1)\n(A: there A is 181.91)\n")->measured, 6.0 * std::sin(core::rad_from_deg(0.955)), 1e-6);
    EXPECT_NEAR(indexed("(index 0 3 2 1)\n(A: there A is 0)\n")->measured, 6.0, 1e-9);
    EXPECT_TRUE(indexed("(index 0 3 2 1)\n"));
}

TEST(Millsim, AToolWithoutItsLengthIsFound) {
    for (const char* with : {"S1000 M3", "G43 H2 S1000 M3", "G43 H1 G49 S1000 M3"}) {
        const auto found = contact(twin("G43 H1 S1000 M3", with), "millsim.tool_length");
        ASSERT_TRUE(found) << with;
        EXPECT_EQ(found->line, 9u) << with;
    }
    EXPECT_FALSE(contact(twin("G43 H1 S1000 M3", "G43 S1000 M3"), "millsim.tool_length"));
}

TEST(Millsim, AFeedWithASpindleThatStandsIsFound) {
    for (const char* with : {"G43 H1", "G43 H1 M5", "G43 H1 S1000 M4"}) {
        const auto found = contact(twin("G43 H1 S1000 M3", with), "millsim.spindle");
        ASSERT_TRUE(found) << with;
        EXPECT_EQ(found->line, 10u) << with;
    }
}

TEST(Millsim, OnARotaryAxisContactsAreFound) {
    EXPECT_TRUE(contact(replaced(kTurned, "G1 Z8 F100", "G0 Z8\nF100"), "millsim.rapid"));
    EXPECT_TRUE(contact(replaced(kTurned, "45 4 6 4 30 19", "45 4 1 6 30 19"), "millsim.shank"));
    EXPECT_TRUE(contact(replaced(kTurned, "45 4 6 4 30 19", "45 4 6 4 1.5 19"), "millsim.holder"));
    EXPECT_TRUE(contact(replaced(kTurned, "clamp round 8 -40 -20", "clamp round 38.1 -40 -9"), "millsim.clamp"));
    EXPECT_FALSE(contact(replaced(kTurned, "clamp round 8 -40 -20", "clamp round 37.9 -40 -9"), "millsim.clamp"));
}

TEST(Millsim, TheReleasedPieceHasNoSheetAroundIt) {
    Stock stock(-5, 5, -5, 5, 1.0);
    for (std::size_t cell = 0; cell < stock.cells.size(); ++cell) {
        const double r = std::max(std::abs(stock.x_of(cell % 10)), std::abs(stock.y_of(cell / 10)));
        if (r < 2.0 || r > 4.0) stock.cells[cell] = {{-3.0, 0.0}};
    }
    stock.cells[2 * 10 + 5] = stock.cells[1 * 10 + 5] = {{-3.0, -2.5}};  // a tab
    const Stock piece = released(stock, 0.5);
    EXPECT_TRUE(piece.top(0.5, 0.5));
    EXPECT_FALSE(piece.top(4.5, 4.5));
    EXPECT_FALSE(piece.top(0.5, -2.5));
}

}  // namespace
}  // namespace fusee::toolpath::mill
