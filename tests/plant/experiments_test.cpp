#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fusee/plant/case_files.h"

namespace fusee::plant {
namespace {

Measured measured(const TestRig& test_rig, bool heldout = false) {
    Random noise(5, 1, 77);
    return measure(test_rig, set_points(heldout, range_of(test_rig.nominal).scale), noise);
}

double mean_load(const Measured& m, std::size_t side, bool backdrive, double motor) {
    double sum = 0.0, rows = 0.0;
    for (const BreakAwayRow& r : m.breakaway)
        if (r.side == side && r.backdrive == backdrive && r.motor == motor) sum += r.load, rows += 1.0;
    return sum / rows;
}

// Levels tau/(1 - mu) and tau/(1 + mu). Three repeats of a friction that scatters by 3 %: 4 sigma of their mean are 7 % of the friction;
// mu itself is off by 2 %, the motor by 0.5 %.
TEST(Experiments, BreakAwayAtTheFrictionCone) {
    const TestRig test_rig = draw_test_rig(11, 0);
    const Measured m = measured(test_rig);
    const double mu = test_rig.nominal.mu;
    for (const std::size_t side : {0U, 1U})
        for (const double motor : set_points(false, range_of(test_rig.nominal).scale).breakaway) {
            const double up = motor / (1.0 - mu), down = motor / (1.0 + mu);
            EXPECT_NEAR(mean_load(m, side, true, motor), up, 0.15 * (up - motor) + 0.015 * up + 4e-3) << motor;
            EXPECT_NEAR(mean_load(m, side, false, motor), down, 0.15 * (motor - down) + 0.015 * motor + 4e-3) << motor;
        }
}

// A faultless spring is its law inside 4 sigma of build (0.8 % of rate; 3e-5 m of arm; 5 mrad, 5e-5 m of preload) and of sensors.
TEST(Experiments, SpringPullIsTheLaw) {
    const TestRig test_rig = draw_test_rig(11, 1);
    const SpringCurves& law = test_rig.nominal.springs;
    for (const PullRow& row : measured(test_rig).spring_pull) {
        const double drawn = row.deflection <= 0.0 ? 0.0 : torque_at(law.deflection, row.series ? law.se : law.pe, row.deflection);
        EXPECT_NEAR(row.torque, drawn, 0.06 * drawn + 0.012) << row.series << ' ' << row.deflection;
    }
}

TEST(Experiments, FaultlessRowsAreOfTheFormatsKind) {
    const TestRig test_rig = draw_test_rig(11, 2);
    const Measured m = measured(test_rig), kept = measured(test_rig, true);
    EXPECT_EQ(m.breakaway.size(), 96U);
    EXPECT_EQ(m.spring_pull.size(), 484U);
    EXPECT_EQ(m.dead_band.size(), 21U);
    EXPECT_EQ(m.joint_stiffness.size(), 300U);
    EXPECT_EQ(m.cocontraction.size(), 122U);
    EXPECT_EQ(m.log.size(), 801U);
    EXPECT_EQ(kept.breakaway.size(), 48U);
    EXPECT_EQ(kept.dead_band.size(), 18U);
    EXPECT_EQ(kept.joint_stiffness.size(), 200U);
    for (const DeadBandRow& row : m.dead_band) {
        EXPECT_LT(row.q_low, 0.05);
        EXPECT_GT(row.q_high, -0.05);
        EXPECT_LE(row.push, range_of(test_rig.nominal).most_push + 1e-3);
    }
    for (const LogRow& row : m.log)
        for (const double theta : row.theta) EXPECT_GT(theta, -0.01);
    const CocontractionRow& top = m.cocontraction[60];
    EXPECT_TRUE(top.up);
    EXPECT_NEAR(top.motor, test_rig.nominal.top_torque, 1e-12);
    // Loads at the top: torque/(1 + mu).
    const SpringCurves& law = test_rig.nominal.springs;
    EXPECT_NEAR(top.theta[0], deflection_at(law.deflection, load_of(law), top.motor / (1.0 + test_rig.nominal.mu)), 0.06);
}

TEST(Experiments, AngleReadingsAreWholeStepsOfTheEncoder) {
    const TestRig test_rig = draw_test_rig(11, 3);
    for (const LogRow& row : measured(test_rig).log) {
        const double steps = row.q / test_rig.sensors.encoder_step;
        EXPECT_NEAR(steps, std::round(steps), 1e-9);
    }
}

}  // namespace
}  // namespace fusee::plant
