#include "fusee/joint_model/uncertainty.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fixture.h"

// The noise of the sensors as the rows show it (docs/theory/diagnosis.md, "Noise").
namespace fusee::joint_model {
namespace {

/// A log, pulls and repeats of break-aways whose sensors scatter `factor` times as much as stated; smooth otherwise.
gap_case::Case noisy_case(double factor) {
    gap_case::Case own;
    own.rig = fixtures::straight_rig();
    own.sensors.encoder_step = 0.0;
    std::mt19937_64 random(11);
    std::normal_distribution<double> normal(0.0, factor);
    for (int i = 0; i < 800; ++i) {
        const double t = 0.01 * i, angle = 2.0 + std::sin(t), noise = own.sensors.encoder_noise;
        own.rows.log.push_back({t, 0.7, 0.7, 0.0, angle + noise * normal(random), angle + noise * normal(random), noise * normal(random)});
    }
    for (int i = 0; i < 200; ++i)
        own.rows.spring_pull.push_back({.deflection = 0.01 * i, .torque = 0.3 * 0.01 * i + own.sensors.torque_noise * normal(random)});
    for (int i = 0; i < 96; ++i) {
        const double torque = 0.5 + 0.1 * (i / 3), mu = own.rig.gear_load_friction;
        const double load = torque / (1.0 + mu);
        own.rows.breakaway.push_back(
            {.side = "agonist", .backdrive = false, .motor_torque = torque, .load_torque = load * (1.0 + 0.008 * normal(random))});
    }
    return own;
}

TEST(MeasuredScatter, IsOneWhereTheSensorsAreAsStated) {
    const Uncertainty known = uncertainty(noisy_case(1.0));
    EXPECT_TRUE(known.scatter.remarks.empty()) << known.scatter.remarks.front();
    EXPECT_EQ(known.scatter.encoder[2], 1.0);
}

TEST(MeasuredScatter, RaisesTheSigmaOfEverySensorThatScattersMore) {
    const gap_case::Case loud = noisy_case(3.0);
    const Uncertainty known = uncertainty(loud), stated = uncertainty(loud, {});
    ASSERT_EQ(known.scatter.remarks.size(), 5U);
    for (const double encoder : known.scatter.encoder) EXPECT_NEAR(encoder, 3.0, 0.4);
    EXPECT_NEAR(known.scatter.spring_pull, 2.8, 0.5);  // a part of its sigma is the encoder's, which is smooth here
    EXPECT_GT(known.scatter.breakaway, 1.5);
    for (const gap_case::Experiment e : {gap_case::Experiment::kBreakAway, gap_case::Experiment::kSpringPull})
        for (std::size_t i = 0; i < known.sigma[e].size(); ++i) EXPECT_GT(known.sigma[e][i], 1.5 * stated.sigma[e][i]);
    EXPECT_NE(known.scatter.remarks.front().find("[sensors]"), std::string::npos) << known.scatter.remarks.front();
}

}  // namespace
}  // namespace fusee::joint_model
