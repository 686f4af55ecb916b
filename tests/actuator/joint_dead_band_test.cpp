#include <gtest/gtest.h>

#include <algorithm>

#include "fusee/actuator/dead_band.h"
#include "fusee/actuator/equilibrium.h"
#include "fusee/core/error.h"
#include "random_joint.h"

namespace fusee::actuator {
namespace {

using Eigen::Vector3d;

Actuator symmetric_with(spring::FrictionLaw friction, double ratio = 1.5) {
    return {.law = *spring::make_stiction_law({.k = 0.225, .u = 0.0012, .c = 0.265, .mu = 0.28, .start_torque = 0.6, .end_torque = 2.4}),
            .capstan_radius = 0.03,
            .joint_radius = 0.03 * ratio,
            .gear_friction = std::move(friction),
            .least_torque = 0.85,
            .peak_torque = 1.0,
            .overdrive_torque = 1.5};
}

TEST(JointDeadBand, IsTheSymmetricOneAtEqualTorques) {
    for (const spring::FrictionLaw& friction : {spring::FrictionLaw::proportional(0.28), spring::FrictionLaw::affine(0.02, 0.2, 0.1),
                                                spring::FrictionLaw::tabulated({0.0, 0.5, 1.0, 2.0}, {0.02, 0.1, 0.25, 0.4})}) {
        const Actuator actuator = symmetric_with(friction);
        const Joint joint = joint_of(actuator);
        for (const double tau : {1.0, 1.2, 1.5}) {
            const DeadBand one = dead_band(actuator, tau);
            const JointDeadBand other = joint_dead_band(joint, tau, tau);
            ASSERT_TRUE(one.covered && other.covered) << tau;
            EXPECT_NEAR(other.linear, one.linear, 1e-9 * one.linear);
            EXPECT_NEAR(other.exact_width, one.exact_width, 1e-9 * one.exact_width);
            EXPECT_NEAR(other.edges.low, -other.edges.high, 1e-9 * one.exact_width);
            EXPECT_NEAR(other.z[kAgonist], one.theta, 1e-12);
            EXPECT_NEAR(other.joint_stiffness, one.joint_stiffness, 1e-9 * one.joint_stiffness);
            EXPECT_NEAR(other.free_joint_stiffness, one.free_joint_stiffness, 1e-9 * one.free_joint_stiffness);
            for (const double condition : other.condition_6) EXPECT_NEAR(condition, one.condition_6, 1e-9);
        }
    }
}

/// Four unlike springs of the third order in energy and more, so that nothing cancels by symmetry.
Joint cubic_joint(const spring::FrictionLaw& friction) {
    return antagonist(spring::make_polynomial({0.0, 0.30, 0.05, 0.02}), spring::make_polynomial({0.0, 0.20, 0.12, 0.05}),
                      spring::make_polynomial({0.0, 0.35, 0.04, 0.08}), spring::make_polynomial({0.0, 0.15, 0.09, 0.03}),
                      {friction, friction}, 0.02, 0.03);
}

/// T of the antagonist and the slopes that P(5) is written in.
struct Side {
    double s, p, s_slope, p_slope;
    [[nodiscard]] double transmission() const { return s / (s + p); }
};
Side antagonist_side(const Joint& joint, const Vector3d& z) {
    const spring::Potential &se = *joint.springs[2].potential, &pe = *joint.springs[3].potential;
    const double x = z[kAntagonist] - joint.ratio() * z[kOutput], theta = z[kAntagonist];
    return {se.stiffness(x), pe.stiffness(theta), se.slope(x), pe.slope(theta)};
}

/// The corrected P(5) is the derivative that it names; the printed one is not (physics: factors paired wrongly, a sign lost).
TEST(JointDeadBand, CorrectedP5IsTheDerivativeAndThePrintedOneIsNot) {
    const spring::FrictionLaw friction = spring::FrictionLaw::affine(0.03, 0.2);
    const Joint joint = cubic_joint(friction);
    const double tau_1 = 0.7, tau_2 = 0.9, h = 1e-4;
    const auto transmitted = [&](double tau) {
        return antagonist_side(joint, find_equilibrium(joint, {tau_1, tau, 0.0}).value().z).transmission() * friction.at_rest(tau);
    };
    const double slope =
        (8.0 * (transmitted(tau_2 + h) - transmitted(tau_2 - h)) - transmitted(tau_2 + 2 * h) + transmitted(tau_2 - 2 * h)) / (12.0 * h);

    const JointDeadBand band = joint_dead_band(joint, tau_1, tau_2);
    EXPECT_NEAR(band.condition_5[kAntagonist], slope, 1e-10);  // the difference errs by h^4 and 1e-16/h

    const Side side = antagonist_side(joint, band.z);
    const Eigen::Matrix3d m = sensitivity(joint, band.z).value();
    const double theta = m(kAntagonist, kAntagonist), q = joint.ratio() * m(kOutput, kAntagonist), sum = side.s + side.p;
    const double corrected = (side.s_slope * side.p * (theta - q) - side.s * side.p_slope * theta) / (sum * sum) * friction.at_rest(tau_2) +
                             side.transmission() * friction.slope(tau_2);
    EXPECT_NEAR(band.condition_5[kAntagonist], corrected, 1e-14);
    const double printed = (side.s * side.p_slope * (theta + q) - side.s_slope * side.p * theta) / (sum * sum) * friction.at_rest(tau_2) +
                           side.transmission() * friction.slope(tau_2);
    EXPECT_GT(std::abs(printed - slope), 0.1 * std::abs(slope));
}

TEST(JointDeadBand, ConditionsAreDerivativesOnRandomActuators) {
    RandomJoint random(41);
    int checked = 0;
    for (int i = 0; i < 500; ++i) {
        const Joint joint = random.antagonist();
        Vector3d place = random.place(joint);
        place[kOutput] = 0.0;
        const Vector3d torque = spring_torques(joint, place);
        const JointDeadBand band = joint_dead_band(joint, torque[0], torque[1]);
        if (std::isnan(band.linear)) continue;  // the two sides do not balance near this place
        const auto transmitted = [&](const Vector3d& at, int side) {
            const Eigen::Matrix3d m = sensitivity(joint, find_equilibrium(joint, at, band.z).value().z).value();
            return std::abs(m(kOutput, side) / m(kOutput, kOutput)) / joint.ratio() *
                   joint.gear_friction[static_cast<std::size_t>(side)].at_rest(at[side]);
        };
        const Eigen::Matrix3d m = sensitivity(joint, band.z).value();
        const double h = 1e-4 / m.cwiseAbs().maxCoeff();
        for (int side = 0; side < 2; ++side) {
            const auto slope = [&](const Vector3d& way) {
                const Vector3d at(torque[0], torque[1], 0.0);
                return (transmitted(at + h * way, side) - transmitted(at - h * way, side)) / (2.0 * h);
            };
            const auto s = static_cast<std::size_t>(side);
            const double scale = 1.0 + m.cwiseAbs().maxCoeff();
            ASSERT_NEAR(band.condition_5[s], slope(Vector3d::Unit(side)), 1e-6 * scale) << i;
            ASSERT_NEAR(band.condition_6[s], slope({1.0, 1.0, 0.0}), 1e-6 * scale) << i;
            ++checked;
        }
    }
    EXPECT_GT(checked, 200);
}

/// No pair of loads that stiction allows moves the joint farther than the two corners do.
TEST(JointDeadBand, NoLoadsInsideReachBeyondItsEdges) {
    RandomJoint random(42);
    const Joint joint = cubic_joint(spring::FrictionLaw::affine(0.03, 0.2));
    const JointDeadBand band = joint_dead_band(joint, 0.7, 0.9);
    ASSERT_TRUE(band.covered);
    EXPECT_LT(band.edges.low, band.z[kOutput]);
    EXPECT_GT(band.edges.high, band.z[kOutput]);
    const core::Range one = joint.gear_friction[0].resting_loads(0.7), two = joint.gear_friction[1].resting_loads(0.9);
    core::Range met{1e9, -1e9};
    for (int i = 0; i < 2000; ++i) {
        const auto rest = find_equilibrium(joint, {random.within(one.low, one.high), random.within(two.low, two.high), 0.0});
        ASSERT_TRUE(rest);
        met = {std::min(met.low, rest->z[kOutput]), std::max(met.high, rest->z[kOutput])};
    }
    EXPECT_GE(met.low, band.edges.low);
    EXPECT_LE(met.high, band.edges.high);
    EXPECT_GT(met.width(), 0.9 * band.exact_width);
}

/// The frame subsystem: masses for motors, no gears. Nothing is left of the dead-band.
TEST(JointDeadBand, VanishesWithoutGears) {
    const JointDeadBand band = joint_dead_band(joint_of(symmetric_with(spring::FrictionLaw::proportional(0.28)), false), 1.0, 1.0);
    EXPECT_EQ(band.linear, 0.0);
    EXPECT_NEAR(band.exact_width, 0.0, 1e-13);
    EXPECT_TRUE(band.covered);
}

TEST(JointDeadBand, SaysWhereTheLawsEnd) {
    const Joint joint = joint_of(symmetric_with(spring::FrictionLaw::proportional(0.28)));
    const JointDeadBand edge = joint_dead_band(joint, 1.9, 1.9);  // rests inside, but 2.64 Nm lies beyond the law
    EXPECT_FALSE(edge.covered);
    EXPECT_TRUE(std::isnan(edge.exact_width));
    EXPECT_GT(edge.linear, 0.0);
    const JointDeadBand none = joint_dead_band(joint, 3.0, 3.0);
    EXPECT_FALSE(none.covered);
    EXPECT_TRUE(std::isnan(none.linear));
    EXPECT_THROW((void)joint_dead_band(joint, std::nan(""), 1.0), core::InvalidInput);
}

}  // namespace
}  // namespace fusee::actuator
