#include "init/scale.h"

#include <gtest/gtest.h>

#include "fusee/checks/limits.h"
#include "fusee/pipeline/design.h"

namespace fusee::search::init {
namespace {

const profile::Profile& shipped() {
    static const profile::Profile pnrvsa = profile::read_profile(FUSEE_SOURCE_DIR "/profiles/pnrvsa.toml");
    return pnrvsa;
}

core::Range arms(const profile::Profile& p, cam::PartKind kind) {
    const auto cam = pipeline::design_cam(kind, *pipeline::resolve(p));
    core::Range range{1.0, 0.0};
    for (const cam::Contact& c : cam->working) range = {std::min(range.low, c.arm.arm), std::max(range.high, c.arm.arm)};
    return range;
}

TEST(Scale, OneIsTheShippedDesign) {
    // T(0.6 Nm) = 0.0012^2/(0.28 0.6^2) + 0.265/0.6 of the shipped law
    const Scale one{.transmission = 0.441680952, .u_share = 3.2343e-5, .start = 0.6 / (0.85 / 1.28), .end = 2.21 / (1.5 / 0.72)};
    const profile::Profile p = scaled("mine", {}, one);
    const auto& law = std::get<spring::StictionLawOptions>(p.law.curves);
    EXPECT_NEAR(law.k, 0.225, 1e-6);
    EXPECT_NEAR(law.u, 0.0012, 1e-6);
    EXPECT_NEAR(law.c, 0.265, 1e-6);
    EXPECT_NEAR(p.law.end_torque, 2.21, 1e-5);
    EXPECT_DOUBLE_EQ(p.k_se.spring.rate, shipped().k_se.spring.rate);
    EXPECT_DOUBLE_EQ(p.k_pe.spring.preload, shipped().k_pe.spring.preload);
    EXPECT_NEAR(arms(p, cam::PartKind::kParallel).low, arms(shipped(), cam::PartKind::kParallel).low, 1e-7);
}

/// Numbers have 6 digits. Twice the torque on cams of three times the size: the arms are three times as long, and the dead-band is the
/// same.
TEST(Scale, ArmsGrowWithTheLengthsAlone) {
    Answers answers;
    const profile::Profile one = scaled("mine", answers, {});
    answers.torque = 2.0;
    const profile::Profile large = scaled("mine", answers, {.k_pe = 3.0, .k_se = 3.0});
    for (const cam::PartKind kind : {cam::PartKind::kSeries, cam::PartKind::kParallel}) {
        const core::Range small_arms = arms(one, kind), large_arms = arms(large, kind);
        EXPECT_NEAR(large_arms.low, 3.0 * small_arms.low, 2e-5 * small_arms.low);
        EXPECT_NEAR(large_arms.high, 3.0 * small_arms.high, 2e-5 * small_arms.high);
    }
    EXPECT_NEAR(large.k_pe.spring.rate, 2.0 / 9.0 * one.k_pe.spring.rate, 1e-5 * one.k_pe.spring.rate);
    EXPECT_NEAR(large.k_se.spring.rate, 2.0 * one.k_se.spring.rate, 1e-5 * one.k_se.spring.rate);
}

TEST(Scale, AStatedJointStiffnessIsThatOfTheLaw) {
    Answers answers;
    answers.joint_stiffness = 0.7;
    answers.ratio = 1.5;
    const profile::Profile p = scaled("mine", answers, {});
    const double s = pipeline::resolve(p)->law()->at_load(answers.peak_torque()).s;
    EXPECT_NEAR(2.0 * 1.5 * 1.5 * s, 0.7, 1e-5);
}

TEST(Scale, AShaftWithoutAKeyGetsAFlat) {
    Answers answers;
    answers.shaft = 4e-3;
    EXPECT_EQ(scaled("mine", answers, {}).k_se.solid.hub.lock, solid::HubLock::kDFlat);
    answers.shaft = 10e-3;
    const solid::HubOptions hub = scaled("mine", answers, {}).k_se.solid.hub;
    EXPECT_EQ(hub.lock, solid::HubLock::kKeyway);
    EXPECT_DOUBLE_EQ(hub.key_width, 3e-3);  // DIN 6885-1, above 8 to 10 mm
}

/// Torsion of a tube, 16 M D/(pi (D^4 - d^4)), at most an eighth of the strength of the plastic: rule structure.layer_strength at its
/// safety of 2. The shipped boss of 2.7 shafts is thick enough for the shipped torque.
TEST(Scale, APrintedBossBearsTheTorque) {
    Answers answers;
    EXPECT_NEAR(scaled("mine", answers, {}).k_pe.solid.hub.boss_diameter, 2.7 * answers.shaft, 1e-9);
    answers.torque = 10.0;
    const profile::Profile p = scaled("mine", answers, {});
    const solid::HubOptions& hub = p.k_pe.solid.hub;
    const double hole = 2.0 * std::hypot(0.5 * hub.bore_diameter + hub.key_depth, 0.5 * hub.key_width), outside = hub.boss_diameter;
    const double shear = 16.0 * 0.75 * p.law.end_torque * outside / (core::kPi * (std::pow(outside, 4) - std::pow(hole, 4)));
    EXPECT_NEAR(shear, checks::material_of(p.process).strength / 8.0, 1e-4 * shear);
    answers.process = checks::ProcessKind::kMill;
    EXPECT_NEAR(scaled("mine", answers, {}).k_pe.solid.hub.boss_diameter, 2.7 * answers.shaft, 1e-9) << "no layers";
}

}  // namespace
}  // namespace fusee::search::init
