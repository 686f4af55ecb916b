#include "fusee/actuator/joint.h"

#include <gtest/gtest.h>

#include "random_joint.h"
#include "refused.h"

namespace fusee::actuator {
namespace {

using Eigen::Vector3d;

Actuator symmetric() {
    return {.law = *spring::make_stiction_law({.k = 0.225, .u = 0.0012, .c = 0.265, .mu = 0.28, .start_torque = 0.6, .end_torque = 2.21}),
            .capstan_radius = 0.03,
            .joint_radius = 0.045,
            .gear_friction = spring::FrictionLaw::proportional(0.28),
            .least_torque = 0.85,
            .peak_torque = 1.0,
            .overdrive_torque = 1.5};
}

/// The work done on any small way is the energy gained; the stiffness is its second derivative and symmetric.
TEST(Joint, TorquesAreTheEnergysSlopesAndStiffnessTheirs) {
    RandomJoint random(21);
    for (int i = 0; i < 200; ++i) {
        const Joint joint = random.antagonist();
        const Vector3d z = random.place(joint);
        const Vector3d torques = spring_torques(joint, z);
        const Eigen::Matrix3d k = stiffness(joint, z);
        const double h = 1e-5, scale = 1.0 + k.cwiseAbs().maxCoeff();  // differences err by h^2 of higher slopes, and by 1e-16/h
        for (int body = 0; body < 3; ++body) {
            const Vector3d step = h * Vector3d::Unit(body);
            ASSERT_NEAR((energy(joint, z + step) - energy(joint, z - step)) / (2.0 * h), torques[body], 1e-7 * scale) << i;
            const Vector3d rise = (spring_torques(joint, z + step) - spring_torques(joint, z - step)) / (2.0 * h);
            ASSERT_NEAR((rise - k.col(body)).lpNorm<Eigen::Infinity>(), 0.0, 1e-6 * scale) << i;
        }
        ASSERT_EQ((k - k.transpose()).norm(), 0.0);
    }
}

/// Paper (1) in the joint's own signs, written out.
TEST(Joint, AntagonistIsTheFourSpringsOfFigure3) {
    const auto u = [](double rate) { return spring::make_polynomial({0.1, rate, 0.02}); };
    const auto f = [](double rate, double x) { return 0.1 + rate * x + 0.02 * x * x; };
    const Joint joint = antagonist(u(0.1), u(0.2), u(0.3), u(0.4),
                                   {spring::FrictionLaw::proportional(0.1), spring::FrictionLaw::proportional(0.2)}, 0.02, 0.03);
    const double g = 1.5, theta_1 = 1.2, theta_2 = 1.7, q = 0.25;
    const Vector3d torques = spring_torques(joint, {theta_1, theta_2, q});
    EXPECT_NEAR(torques[kAgonist], f(0.1, theta_1) + f(0.2, theta_1 + g * q), 1e-15);
    EXPECT_NEAR(torques[kAntagonist], f(0.4, theta_2) + f(0.3, theta_2 - g * q), 1e-15);
    EXPECT_NEAR(torques[kOutput], g * (f(0.2, theta_1 + g * q) - f(0.3, theta_2 - g * q)), 1e-15);
    EXPECT_EQ(joint.gear_friction[0].mu(), 0.1);
    EXPECT_EQ(joint.gear_friction[1].mu(), 0.2);
    EXPECT_EQ(joint.springs[2].name, "K_SE antagonist");
}

TEST(Joint, SymmetricActuatorRestsWhereItsLawDoes) {
    const Actuator actuator = symmetric();
    const Joint joint = joint_of(actuator);
    const spring::LawPoint p = actuator.law->at_load(1.0);
    const Vector3d torques = spring_torques(joint, {p.theta, p.theta, 0.0});
    EXPECT_NEAR(torques[kAgonist], 1.0, 1e-14);
    EXPECT_NEAR(torques[kAntagonist], 1.0, 1e-14);
    EXPECT_NEAR(torques[kOutput], 0.0, 1e-15);
    EXPECT_NEAR(energy(joint, {p.theta, p.theta, 0.0}), 2.0 * (p.u_se + p.u_pe), 1e-15);
    EXPECT_EQ(joint.gear_friction[0].mu(), 0.28);
    EXPECT_EQ(joint_of(actuator, false).gear_friction[1].mu(), 0.0);
    EXPECT_NEAR(joint.ratio(), 1.5, 1e-15);
}

TEST(Joint, SpringsOutsideTheirLawAreNamed) {
    const Joint joint = joint_of(symmetric());
    const double end = symmetric().law->angles().high;
    EXPECT_TRUE(outside(joint, {0.0, end, 0.0}).empty());
    EXPECT_EQ(outside(joint, {-0.01, 0.3, 0.02}), (std::vector<std::string>{"K_PE agonist"}));
    EXPECT_EQ(outside(joint, {0.3, 0.3, end}), (std::vector<std::string>{"K_SE agonist", "K_SE antagonist"}));
}

TEST(JointRefusal, MissingPartsAreNamed) {
    const auto spring = spring::make_polynomial({0.0, 1.0});
    const std::array<spring::FrictionLaw, 2> gears{spring::FrictionLaw::proportional(0.0), spring::FrictionLaw::proportional(0.0)};
    const auto field = [&](const spring::PotentialPtr& u3, double capstan, double joint) {
        return field_refused([&] { return antagonist(spring, spring, u3, spring, gears, capstan, joint); });
    };
    EXPECT_EQ(field(spring, 0.02, 0.03), "accepted");
    EXPECT_EQ(field(nullptr, 0.02, 0.03), "u3");
    EXPECT_EQ(field(spring, 0.0, 0.03), "capstan_radius");
    EXPECT_EQ(field(spring, 0.02, -0.03), "joint_radius");
}

}  // namespace
}  // namespace fusee::actuator
