#include "fusee/gap_case/break_away.h"

#include <gtest/gtest.h>

#include "fusee/core/error.h"
#include "gap_case/test_day.h"

namespace fusee::gap_case {
namespace {

using fixtures::line_of;
using fixtures::remark_of;

// Roundtrip: what the friction law says a resting capstan may carry is what a test without scatter measures.
TEST(IdentifyFriction, GivesBackTheLawThatMadeTheRows) {
    for (const double constant : {0.0, 0.02}) {
        const spring::FrictionLaw law = spring::FrictionLaw::affine(constant, 0.28);
        std::vector<BreakAway> rows;
        for (const double motor : {0.1, 0.4, 0.9, 1.3}) {
            rows.push_back({"agonist", true, motor, law.resting_loads(motor).high});
            rows.push_back({"agonist", false, motor, law.resting_loads(motor).low});
        }
        const FrictionReport report = identify_friction(rows);
        for (const char* group : {"all", "drive", "backdrive"}) {
            EXPECT_NEAR(line_of(report, group).mu, 0.28, 1e-12) << group;
            EXPECT_NEAR(line_of(report, group).constant, constant, 1e-12) << group;
            EXPECT_NEAR(line_of(report, group).robust_mu, 0.28, 1e-12) << group;
        }
        EXPECT_EQ(report.lines.size(), 3u);  // one side: it is not repeated
        ASSERT_TRUE(report.law);
        EXPECT_NEAR(report.law->mu, 0.28, 1e-12);
        EXPECT_NEAR(report.law->constant, constant, 1e-12);
        EXPECT_EQ(report.profile_lines().find("constant") != std::string::npos, constant > 0.0);
    }
}

TEST(IdentifyFriction, AGroupForEverySideAndDirection) {
    const FrictionReport report = identify_friction(fixtures::measure({.relative = 0.03}, 1));
    std::vector<std::string> names;
    for (const FrictionLine& line : report.lines) names.push_back(line.group);
    EXPECT_EQ(names, (std::vector<std::string>{"all", "backdrive", "drive", "agonist", "antagonist", "agonist backdrive", "agonist drive",
                                               "antagonist backdrive", "antagonist drive"}));
    EXPECT_EQ(report.lines.front().rows, 72u);
    EXPECT_GT(report.lines.front().r_squared, 0.99);
    EXPECT_TRUE(remark_of(report, "constant")->text.find("not distinguishable from 0") != std::string::npos);
    for (const char* id : {"directions", "sides", "curvature", "outliers", "wrong_way", "law"})
        EXPECT_EQ(remark_of(report, id), nullptr) << id;
    EXPECT_EQ(report.repeats.size(), 24u);
    for (const FrictionReport::Repeat& r : report.repeats) {
        EXPECT_EQ(r.rows, 3u);
        EXPECT_NEAR(r.mean_friction, std::abs(r.mean_load - r.motor_torque), 1e-12);
        EXPECT_LT(r.deviation, 0.12 * r.mean_friction);  // 3 % scatter; four deviations
    }
}

// The load stands on both sides of tau_f = |motor - load|: a plain regression on it is biased by its own scatter.
TEST(IdentifyFriction, ScatterOfTheLoadDoesNotBiasMu) {
    const fixtures::TestDay day{.absolute = 0.1, .sides = {"one"}, .repeats = 500};
    const std::vector<BreakAway> rows = fixtures::measure(day, 2);
    std::vector<double> load, friction, ones;
    for (const BreakAway& row : rows) {
        if (!row.backdrive) continue;
        load.push_back(row.load_torque);
        friction.push_back(row.friction());
        ones.push_back(1.0);
    }
    const double plain = math::fit_linear({{ones, load}, friction, {}, {}}).coefficients[1];
    const FrictionReport report = identify_friction(rows);
    EXPECT_NEAR(plain, 0.321, 0.01);  // (1 - mu) times the share that the scatter has in the variance of the loads: 0.041 too much
    EXPECT_NEAR(line_of(report, "backdrive").mu, 0.28, 0.01);  // four standard errors
}

TEST(IdentifyFriction, SaysWhichDifferencesAreNoChance) {
    std::vector<BreakAway> rows = fixtures::measure({.relative = 0.03}, 3), other = fixtures::measure({.mu = 0.36, .relative = 0.03}, 4);
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i].side == "agonist") rows[i] = other[i];
    const FrictionReport sides = identify_friction(rows);
    ASSERT_NE(remark_of(sides, "sides"), nullptr);
    EXPECT_LT(remark_of(sides, "sides")->p, 1e-6);
    EXPECT_EQ(remark_of(sides, "directions"), nullptr);

    rows = fixtures::measure({.relative = 0.03}, 5);
    for (BreakAway& row : rows) row.motor_torque /= 1.1;  // the motor gives 10 % more than it says
    const FrictionReport scaled = identify_friction(rows);
    ASSERT_NE(remark_of(scaled, "directions"), nullptr);
    EXPECT_NE(remark_of(scaled, "motor_torque")->text.find("% more torque than stated"), std::string::npos)
        << remark_of(scaled, "motor_torque")->text;

    const FrictionReport constant = identify_friction(fixtures::measure({.constant = 0.03, .relative = 0.03}, 6));
    EXPECT_LT(remark_of(constant, "constant")->p, 1e-6);
    EXPECT_NEAR(constant.law->constant, 0.03, 0.004);

    rows = fixtures::measure({.relative = 0.02}, 7);
    for (BreakAway& row : rows)
        row.load_torque = row.motor_torque + (row.backdrive ? 1 : -1) * (0.2 * row.motor_torque * row.motor_torque + row.friction());
    EXPECT_NE(remark_of(identify_friction(rows), "curvature"), nullptr);
}

// False alarms: each test is made at 1 %, so of 400 blameless days about 4 are blamed; 13 is four standard deviations more.
TEST(IdentifyFriction, SeldomBlamesABlamelessBench) {
    int directions = 0, sides = 0, curvature = 0;
    for (unsigned day = 0; day < 400; ++day) {
        const FrictionReport report = identify_friction(fixtures::measure({.relative = 0.04}, 100 + day));
        directions += remark_of(report, "directions") != nullptr;
        sides += remark_of(report, "sides") != nullptr;
        curvature += remark_of(report, "curvature") != nullptr;
    }
    EXPECT_LE(directions, 13);
    EXPECT_LE(sides, 13);
    EXPECT_LE(curvature, 13);
}

TEST(IdentifyFriction, OutliersAreNamedAndDoNotMoveTheLaw) {
    std::vector<BreakAway> rows = fixtures::measure({.relative = 0.02}, 8);
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].line = i + 2;
    for (const std::size_t i : {10u, 40u}) rows[i].load_torque *= 1.5;
    const FrictionReport report = identify_friction(rows);
    EXPECT_EQ(report.lines[0].outliers, (std::vector<std::size_t>{10, 40}));
    EXPECT_EQ(report.lines[1].group, "all without outliers");
    EXPECT_EQ(report.lines[1].rows, 70u);
    EXPECT_NE(remark_of(report, "outliers")->text.find("line 12, line 42"), std::string::npos);
    EXPECT_NEAR(report.law->mu, 0.28, 0.005);
    EXPECT_NEAR(report.lines[0].robust_mu, 0.28, 0.01);
    // Row 40 was to be driven, and its load lies above the motor torque.
    EXPECT_EQ(remark_of(report, "wrong_way") != nullptr, !rows[40].backdrive && rows[40].friction() < 0.0);
}

TEST(IdentifyFriction, RowsWithoutFrictionAreALawOfNone) {
    const FrictionReport report = identify_friction({{"a", true, 0.1, 0.1}, {"a", true, 1.0, 1.0}, {"a", false, 0.5, 0.5}});
    ASSERT_TRUE(report.law);
    EXPECT_EQ(report.law->mu, 0.0);
    EXPECT_TRUE(std::isnan(report.lines.front().r_squared));
}

// Two of ten rows hold up the line alone: without them there would be none.
TEST(IdentifyFriction, OutliersThatHoldUpTheLineStay) {
    std::vector<BreakAway> rows;
    for (int i = 0; i < 8; ++i) rows.push_back({"a", true, 0.5, 0.6 + 1e-4 * (i % 3)});
    rows.push_back({"a", true, 1.0, 1.9});
    rows.push_back({"a", true, 1.0, 1.1});
    const FrictionReport report = identify_friction(rows);
    EXPECT_EQ(report.lines.front().outliers, (std::vector<std::size_t>{8, 9}));
    EXPECT_FALSE(report.outliers_left_out);
    EXPECT_EQ(report.trusted().rows, 10u);
}

TEST(IdentifyFriction, RefusesWhatGivesNoLine) {
    const std::vector<BreakAway> two{{"a", true, 0.1, 0.14}, {"a", true, 1.0, 1.4}},
        equal{{"a", true, 0.5, 0.7}, {"a", true, 0.5, 0.71}, {"a", true, 0.5, 0.69}};
    EXPECT_THROW((void)identify_friction({}), core::InvalidInput);
    EXPECT_THROW((void)identify_friction(two), core::InvalidInput);
    EXPECT_THROW((void)identify_friction(equal), core::InvalidInput);
}

TEST(IdentifyFriction, NoGearIsNoLaw) {
    std::vector<BreakAway> rows = fixtures::measure({.relative = 0.03}, 9);
    for (BreakAway& row : rows) row.backdrive = !row.backdrive;
    const FrictionReport report = identify_friction(rows);
    EXPECT_FALSE(report.law);
    EXPECT_NE(remark_of(report, "law"), nullptr);
    EXPECT_NE(remark_of(report, "wrong_way")->text.find("72 rows have"), std::string::npos);
    EXPECT_EQ(report.profile_lines(), "");
}

std::string refusal(const std::string& csv) {
    try {
        (void)parse_break_away(csv, "t.csv");
    } catch (const core::InvalidInput& e) {
        return e.field() + ": " + e.value();
    }
    return "none";
}

TEST(ParseBreakAway, KnowsItsColumnsAndRefusesTheRest) {
    const auto rows = parse_break_away(
        "# bench\nmotor_torque_Nm,side,load_torque_Nm,direction,by\n0.5,left,0.7,backdrive,me\n0.5,left,0.4,drive,me\n", "t.csv");
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_TRUE(rows[0].backdrive);
    EXPECT_NEAR(rows[0].friction(), 0.2, 1e-15);
    EXPECT_NEAR(rows[1].friction(), 0.1, 1e-15);
    EXPECT_EQ(rows[1].line, 4u);
    const std::string head = "side,direction,motor_torque_Nm,load_torque_Nm\n", at = "t.csv";
    EXPECT_EQ(refusal(head + "a,up,1,1\n"), at + ":2:3: direction: 'up'");
    EXPECT_EQ(refusal(head + "a,drive,-1,1\n"), at + ":2:9: motor_torque_Nm: -1");
    EXPECT_EQ(refusal(head + "a,drive,1,-1\n"), at + ":2:11: load_torque_Nm: -1");
    EXPECT_EQ(refusal(head + "a,drive,1e300,1\n"), at + ":2:9: motor_torque_Nm: 1e+300");
    EXPECT_EQ(refusal(head), at + ":1:1: rows: 0");
}

}  // namespace
}  // namespace fusee::gap_case
