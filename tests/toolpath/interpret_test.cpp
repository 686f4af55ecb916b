#include <cstdlib>

#include "exchange/fixtures/expect_refusal.h"
#include "fusee/core/units.h"
#include "toolpath/fixture.h"

namespace fusee::toolpath {
namespace {

/// As rs274 2.9 prints them, for a box of 20 x 20 x 2 mm.
const char* const kRows = R"(executing
    1 N..... USE_LENGTH_UNITS(CANON_UNITS_MM)
    2 N..... COMMENT("stock box -10 10 -10 10 -2 0")
    3 N..... STRAIGHT_TRAVERSE(4.0000, 0.0000, 5.0000, 0.0000, 0.0000, 0.0000)
    4 N..... SET_FEED_RATE(100.0000)
    5 N..... STRAIGHT_FEED(4.0000, 0.0000, -1.0000, 0.0000, 0.0000, 0.0000)
    6 N..... ARC_FEED(0.0000, 4.0000, 0.0000, 0.0000, 1, -1.0000, 0.0000, 0.0000, 0.0000)
    7 N..... ARC_FEED(0.0000, 4.0000, 0.0000, 0.0000, -2, -1.5000, 0.0000, 0.0000, 0.0000)
    8 N..... STRAIGHT_FEED(0.0000, 4.0000, 5.0000, 90.0000, 0.0000, 0.0000)
)";

TEST(Canonical, MovesAreThoseThatArePrinted) {
    const Interpreted program = parse_canonical(kRows, "a.ngc");
    ASSERT_FALSE(program.moves.empty());
    EXPECT_TRUE(program.moves[0].rapid);
    EXPECT_EQ(program.moves[0].from.z, 5.0);  // where the machine stood before is not known
    EXPECT_EQ(program.moves[1].to.z, -1.0);
    EXPECT_EQ(program.moves[1].feed, 100.0);
    EXPECT_EQ(program.moves.back().to.a, 90.0);
    ASSERT_EQ(program.notes.size(), 1u);
    EXPECT_EQ(program.notes[0].before, 0u);
    EXPECT_TRUE(faults(program).empty()) << faults(program).front();
}

// A quarter circle counter-clockwise, then two whole turns clockwise that go down half a millimetre.
TEST(Canonical, ArcsComeAsFineChords) {
    const Interpreted program = parse_canonical(kRows, "a.ngc");
    double turned = 0.0, lowest = 0.0;
    for (const Move& move : program.moves) {
        if (move.row != 6 && move.row != 7) continue;
        const double step =
            std::atan2(move.from.x * move.to.y - move.from.y * move.to.x, move.from.x * move.to.x + move.from.y * move.to.y);
        if (move.row == 7) turned += step;
        lowest = std::min(lowest, move.to.z);
        EXPECT_NEAR(std::hypot(move.to.x, move.to.y), 4.0, 1e-9);
        EXPECT_LE(4.0 * (1.0 - std::cos(0.5 * step)), 5.1e-5);
    }
    EXPECT_NEAR(turned, -4.0 * core::kPi, 1e-9);
    EXPECT_EQ(lowest, -1.5);
}

TEST(Canonical, WhatIsNotUnderstoodIsAnErrorWithItsRow) {
    fixtures::expect_refusal([] { (void)parse_canonical("1 N..... USE_LENGTH_UNITS(CANON_UNITS_INCHES)\n", "a.ngc"); },
                             {"a.ngc", "row 1", "INCHES"});
    fixtures::expect_refusal([] { (void)parse_canonical("\n2 N..... STRAIGHT_FEED(1.0, 2.0)\n", "a.ngc"); }, {"a.ngc", "row 2"});
}

TEST(Faults, RapidInStockNoFeedAndNoStockAreNamed) {
    const auto faults_of = [](const std::string& from, const std::string& to) {
        return faults(parse_canonical(replaced(kRows, from, to), "a.ngc"));
    };
    const auto rapid = faults_of("STRAIGHT_FEED(4.0000, 0.0000, -1.0000", "STRAIGHT_TRAVERSE(4.0000, 0.0000, -1.0000");
    ASSERT_EQ(rapid.size(), 1u);
    EXPECT_NE(rapid[0].find("row 5: a rapid to X4.000 Y0.000 Z-1.000 passes through the stock"), std::string::npos) << rapid[0];
    EXPECT_FALSE(faults_of("SET_FEED_RATE(100.0000)", "SET_FEED_RATE(0.0000)").empty());
    EXPECT_FALSE(faults_of("stock box", "a box").empty());
    EXPECT_TRUE(faults_of("-10 10 -10 10", "-10 -9 -10 10").empty());  // beside the stock everything is free
}

TEST(Faults, RoundStockIsHeldByItsRadius) {
    const std::string round = replaced(kRows, "stock box -10 10 -10 10 -2 0", "stock round 3 -10 10");
    const auto over = [&](const char* y_z) {
        return faults(parse_canonical(replaced(round, "TRAVERSE(4.0000, 0.0000, 5.0000", std::string("TRAVERSE(4.0000, ") + y_z), "a.ngc"));
    };
    EXPECT_TRUE(over("0.0000, 3.1000").empty());
    EXPECT_EQ(over("0.0000, 2.9000").size(), 1u);
    EXPECT_EQ(over("2.0000, 2.2000").size(), 1u);  // 3^2 - 2^2 = 2.236^2
    EXPECT_TRUE(over("2.0000, 2.3000").empty());
    EXPECT_TRUE(over("3.1000, 0.0000").empty());
}

using Controller = InterpreterTest;

TEST_F(Controller, RefusesInItsOwnWords) {
    fixtures::expect_refusal([this] { (void)run("G21\nG1 X1\nM2\n"); }, {"program.ngc", "rs274 ended with 1", "zero feed rate"});
}

TEST_F(Controller, ReadsArcsAndTheRotaryAxis) {
    const Interpreted program = run("G21 G90 G94\nF100\nG1 X2 Y0 A-30\nG3 X2 Y0 I-2 J0 Z-1 P3\nM2\n");
    EXPECT_EQ(program.moves.back().to.z, -1.0);
    EXPECT_EQ(program.moves.back().to.a, -30.0);
}

// rs274 keeps a file in the home folder, and two at a time end each other by it: make interprets the programs of both parts at once.
TEST_F(Controller, LeavesTheHomeFolderAlone) {
    const char* const before = std::getenv("HOME");
    const std::string home = before == nullptr ? "" : before;
    ::setenv("HOME", folder_.c_str(), 1);
    (void)run("G21 G94\nF100\nG1 X1\nM2\n");
    ::setenv("HOME", home.c_str(), 1);
    EXPECT_FALSE(std::filesystem::exists(folder_ / ".tool.mmap"));
}

}  // namespace
}  // namespace fusee::toolpath
