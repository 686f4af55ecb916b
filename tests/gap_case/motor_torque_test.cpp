#include <gtest/gtest.h>

#include "gap_case/test_day.h"

// A torque constant that is off, and friction: told apart by two directions, and by nothing else.
namespace fusee::gap_case {
namespace {

using fixtures::remark_of;

/// Rows of motors that give `scale` of the torque that the rows state.
std::vector<BreakAway> measure_scaled(double scale, const fixtures::TestDay& day, unsigned seed) {
    std::vector<BreakAway> rows = fixtures::measure(day, seed);
    for (BreakAway& row : rows) row.motor_torque /= scale;
    return rows;
}

std::vector<BreakAway> only(std::vector<BreakAway> rows, bool backdrive) {
    std::erase_if(rows, [backdrive](const BreakAway& row) { return row.backdrive != backdrive; });
    return rows;
}

TEST(MotorTorque, OneDirectionHasTwoReadingsAndNoLaw) {
    for (const bool backdrive : {false, true}) {
        const auto rows = only(measure_scaled(0.875, {.mu = 0.0, .absolute = 0.001, .sides = {"one"}}, 1), backdrive);
        const FrictionReport report = identify_friction(rows);
        EXPECT_FALSE(report.law);
        EXPECT_EQ(report.profile_lines(), "");
        EXPECT_TRUE(report.motors.empty());
        ASSERT_EQ(report.one_way.size(), 1U);
        const FrictionReport::OneWay& motor = report.one_way.front();
        EXPECT_EQ(motor.backdrive, backdrive);
        EXPECT_NEAR(motor.scale, 0.875, 0.002);
        EXPECT_TRUE(motor.scale_95.low < motor.scale && motor.scale < motor.scale_95.high);
        EXPECT_NEAR(motor.mu, backdrive ? 1.0 - 1.0 / 0.875 : 1.0 / 0.875 - 1.0, 0.003);
        EXPECT_NEAR(motor.load_by_scale, 1.25, 0.003);
        ASSERT_NE(remark_of(report, "one_way"), nullptr);
        EXPECT_NE(remark_of(report, "one_way")->text.find(backdrive ? "Measure drive" : "Measure backdrive"), std::string::npos);
        EXPECT_EQ(remark_of(report, "constant")->text.find("with the stated torques"), 0U);
    }
}

// The other direction decides: each reading names the load that it expects there.
TEST(MotorTorque, TheMeasurementThatIsAdvisedTells) {
    const auto with_friction = fixtures::measure({.mu = 0.15, .sides = {"one"}}, 1);
    const auto without = measure_scaled(1.0 / 1.15, {.mu = 0.0, .sides = {"one"}}, 1);
    for (const auto* rows : {&with_friction, &without}) {
        const FrictionReport::OneWay motor = identify_friction(only(*rows, false)).one_way.front();
        double load = 0.0;
        for (const BreakAway& row : only(*rows, true))
            if (row.motor_torque == motor.motor_torque) load = row.load_torque;
        EXPECT_NEAR(load, rows == &with_friction ? motor.load_by_friction : motor.load_by_scale, 1e-9);
        EXPECT_GT(std::abs(motor.load_by_friction - motor.load_by_scale), 0.2);
    }
}

TEST(MotorTorque, TwoDirectionsGiveBothWithTheirIntervals) {
    int held = 0;
    constexpr int kDays = 40;
    for (unsigned day = 0; day < kDays; ++day) {
        const FrictionReport report =
            identify_friction(measure_scaled(0.875, {.mu = 0.02, .absolute = 0.002, .sides = {"one"}, .repeats = 4}, 10 + day));
        ASSERT_EQ(report.motors.size(), 1U);
        const FrictionReport::Motor& motor = report.motors.front();
        EXPECT_TRUE(motor.differs);
        EXPECT_NEAR(motor.scale, 0.875, 0.00875);
        ASSERT_TRUE(report.law);
        EXPECT_NEAR(report.law->mu, 0.02, 0.003);
        EXPECT_NE(report.profile_lines().find("torque of one times 0.87"), std::string::npos) << report.profile_lines();
        held += motor.scale_95.holds(0.875) && motor.mu_95.holds(0.02) ? 1 : 0;
    }
    EXPECT_GE(held, 32);  // of 40 with 95 % each, both: 36 expected; four deviations less
}

TEST(MotorTorque, AConstantAndAnOffsetOfTheTorqueAreNoScale) {
    auto rows = fixtures::measure({.mu = 0.1, .constant = 0.02, .absolute = 0.001, .sides = {"one"}}, 5);
    for (BreakAway& row : rows) row.motor_torque += 0.03;
    const FrictionReport::Motor motor = identify_friction(rows).motors.front();
    EXPECT_FALSE(motor.differs) << motor.scale;
    EXPECT_NEAR(motor.mu, 0.1, 0.003);
    EXPECT_NEAR(motor.constant, 0.02, 0.003);
}

TEST(MotorTorque, ASideOfOneDirectionIsLeftOutOfTheLaw) {
    auto rows = fixtures::measure({.mu = 0.2, .absolute = 0.001}, 6);
    std::erase_if(rows, [](const BreakAway& row) { return row.side == "agonist" && row.backdrive; });
    for (BreakAway& row : rows)
        if (row.side == "agonist") row.motor_torque *= 1.3;
    const FrictionReport report = identify_friction(rows);
    ASSERT_EQ(report.one_way.size(), 1U);
    EXPECT_EQ(report.one_way.front().side, "agonist");
    ASSERT_TRUE(report.law);
    EXPECT_NEAR(report.law->mu, 0.2, 0.003);
    EXPECT_EQ(report.law_rows, 36U);
    // Each side in another direction: no motor has both.
    auto crossed = fixtures::measure({.mu = 0.2, .absolute = 0.001}, 7);
    std::erase_if(crossed, [](const BreakAway& row) { return (row.side == "agonist") == row.backdrive; });
    EXPECT_FALSE(identify_friction(crossed).law);
    EXPECT_EQ(identify_friction(crossed).one_way.size(), 2U);
}

// Each test is made at 1 %: of 400 faultless days about 4 are blamed; 13 is four standard deviations more.
TEST(MotorTorque, SeldomBlamesAFaultlessMotor) {
    int blamed = 0;
    for (unsigned day = 0; day < 400; ++day) {
        const FrictionReport report = identify_friction(fixtures::measure({.relative = 0.04}, 100 + day));
        blamed += remark_of(report, "motor_torque")->text.find("is not the stated one") != std::string::npos;
    }
    EXPECT_LE(blamed, 13);
}

}  // namespace
}  // namespace fusee::gap_case
