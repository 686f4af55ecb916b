#include "fusee/actuator/stick_slip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "actuator/random_joint.h"
#include "fusee/core/error.h"
#include "fusee/spring/laws.h"
#include "fusee/spring/potential.h"
#include "refused.h"
#include "with_law.h"

namespace fusee::actuator {
namespace {

using Eigen::Vector3d;

/// The search leaves 1e-11 Nm; the softest spring here has 0.1 Nm/rad.
constexpr double kSolved = 1e-9;

spring::PotentialPtr linear(double stiffness) { return spring::make_polynomial({0.0, stiffness}); }

/// One capstan with a spring to ground; everything else stands still.
Joint single_capstan(double stiffness, const spring::FrictionLaw& gear) {
    Joint joint;
    joint.springs = {{"spring", linear(stiffness), {1.0, 0.0, 0.0}, 0.0}};
    joint.gear_friction[kAgonist] = gear;
    joint.capstan_radius = joint.joint_radius = 0.03;
    joint.frozen = {false, true, true};
    return joint;
}

Joint paper_joint() {
    const auto law = spring::make_stiction_law({.k = 0.225, .u = 0.0012, .c = 0.265, .mu = kMu, .start_torque = 0.6, .end_torque = 2.21});
    return joint_of({.law = *law,
                     .capstan_radius = 0.03,
                     .joint_radius = 0.03,
                     .gear_friction = spring::FrictionLaw::proportional(kMu),
                     .least_torque = 0.8,
                     .peak_torque = 1.0,
                     .overdrive_torque = 1.5});
}

Vector3d random_torque(RandomJoint& random, double ratio) {
    return {random.within(0.2, 1.5), random.within(0.2, 1.5), ratio * random.within(-0.1, 0.1)};
}

/// A capstan winds in while its load is tau/(1+mu), pays out while it is tau/(1-mu), and stays in between.
TEST(StickSlip, PlayOfOneSpringIsAStaircase) {
    const double k = 0.4, low = 1.0 + kMu, high = 1.0 - kMu;
    StickSlip path(single_capstan(k, spring::FrictionLaw::proportional(kMu)));
    const struct {
        double torque, load;
    } stairs[] = {{2.0, 2.0 / low},  {1.5, 2.0 / low}, {1.126, 2.0 / low}, {0.9, 0.9 / high},
                  {1.2, 0.9 / high}, {1.6, 1.6 / low}, {0.0, 0.0}};
    for (const auto& stair : stairs) {
        path.lead_to({stair.torque, 0.0, 0.0}, 5);
        EXPECT_NEAR(path.z()[kAgonist], stair.load / k, kSolved) << stair.torque;
    }
    EXPECT_TRUE(path.inside());
    EXPECT_EQ(path.z()[kAntagonist], 0.0);
    EXPECT_EQ(path.z()[kOutput], 0.0);
}

TEST(StickSlip, RestingBodiesKeepTheirPlaceToTheBit) {
    StickSlip path(paper_joint());
    path.lead_to({1.0, 1.0, 0.0});
    const Vector3d z = path.z();
    path.lead_to({1.2, 0.9, 0.0});
    EXPECT_GT(path.z()[kAgonist], z[kAgonist]);
    EXPECT_EQ(path.z()[kAntagonist], z[kAntagonist]);
    EXPECT_EQ(path.sliding()[kAgonist], 1.0);
    EXPECT_EQ(path.sliding()[kAntagonist], 0.0);
}

/// Stribeck: more torque is held at rest than in motion, so a capstan that breaks away goes on to the load of motion.
TEST(StickSlip, BreaksAwayFromRestAndSlidesOn) {
    const double k = 0.4, mu = 0.2, rest = 1.5 * mu;
    StickSlip path(single_capstan(k, spring::FrictionLaw::affine(0.0, mu, 0.5)));
    const auto load_at = [&](double torque) {
        path.lead_to({torque, 0.0, 0.0}, 1);
        return k * path.z()[kAgonist];
    };
    EXPECT_NEAR(load_at(1.0), 1.0 / (1.0 + mu), kSolved);
    EXPECT_NEAR(load_at(1.1), 1.1 / (1.0 + mu), kSolved);  // slides on: the limit in motion
    const double held = load_at(1.1), breaks = held * (1.0 - rest);
    EXPECT_EQ(path.sliding()[kAgonist], 0.0);
    EXPECT_EQ(load_at(breaks + 1e-6), held);                                     // pays out only beyond the friction at rest,
    EXPECT_NEAR(load_at(breaks - 1e-6), (breaks - 1e-6) / (1.0 - mu), kSolved);  // then down to the load of motion
    EXPECT_NEAR(load_at(0.5), 0.5 / (1.0 - mu), kSolved);
}

/// The output's bearing: a joint without gear friction rests while |2 g b q| <= constant + share g (F_1 + F_2), where F = a +- b q.
TEST(StickSlip, BearingFrictionIsKnownForLinearSprings) {
    const double s = 0.4, p = 0.6, g = 1.5, tau = 1.2;
    const spring::FrictionLaw none = spring::FrictionLaw::proportional(0.0);
    Joint joint = antagonist(linear(p), linear(s), linear(s), linear(p), {none, none}, 0.02, 0.02 * g);
    const double a = s / (s + p) * tau, b = g * s * p / (s + p);
    for (const OutputFriction friction : {OutputFriction{0.02, 0.0}, OutputFriction{0.0, 0.05}, OutputFriction{0.02, 0.05}}) {
        joint.output_friction = friction;
        StickSlip path(joint);
        path.lead_to({tau, tau, 0.0});
        EXPECT_NEAR(path.z()[kOutput], 0.0, kSolved);
        path.lead_to({tau, tau, 0.4});
        path.lead_to({tau, tau, 0.0});
        EXPECT_NEAR(path.z()[kOutput], (friction.constant + friction.tension_share * 2.0 * g * a) / (2.0 * g * b), kSolved);
    }
}

/// The bearing's friction is that of the tension where the output stops, not where it came from.
TEST(StickSlip, BearingFrictionGoesWithTheTension) {
    Joint joint = paper_joint();
    joint.output_friction.tension_share = 0.05;
    StickSlip path(joint);
    path.lead_to({1.0, 1.0, 0.0});
    for (const double push : {0.2, 0.0, -0.2, 0.0}) {
        path.lead_to({1.0, 1.0, push}, 1);
        ASSERT_NE(path.sliding()[kOutput], 0.0) << push;
        double tension = 0.0;
        for (const JointSpring& spring : joint.springs)
            if (spring.jacobian_row[kOutput] != 0.0) tension += spring.potential->force(spring.jacobian_row.dot(path.z()));
        EXPECT_NEAR(spring_torques(joint, path.z())[kOutput], push - path.sliding()[kOutput] * 0.05 * tension, 1e-10) << push;  // g = 1
    }
}

/// However the torques go, no body is left beyond its friction, one that moved is at its limit, and friction never drives.
TEST(StickSlip, NoBodyIsPushedBeyondItsFriction) {
    RandomJoint random(7);
    for (int i = 0; i < 300; ++i) {
        StickSlip path(random.antagonist());
        const Joint& joint = path.joint();
        for (int stroke = 0; stroke < 12; ++stroke) {
            const Vector3d before = path.z();
            path.lead_to(random_torque(random, joint.ratio()), 1);
            const Vector3d loads = spring_torques(joint, path.z()), moved = path.z() - before;
            const double left = 2e-11 * std::max(1.0, path.torque().maxCoeff() / 0.5);  // what the search leaves, of the greatest limit
            for (const int body : {kAgonist, kAntagonist}) {
                const spring::FrictionLaw& gear = joint.gear_friction[body];
                const core::Range rest = gear.resting_loads(path.torque()[body]), motion = gear.moving_loads(path.torque()[body]);
                EXPECT_GE(loads[body], rest.low - left) << i;
                EXPECT_LE(loads[body], rest.high + left) << i;
                if (moved[body] != 0.0) {
                    EXPECT_NEAR(loads[body], moved[body] > 0.0 ? motion.low : motion.high, left) << i;
                }
                EXPECT_GE((path.torque()[body] - loads[body]) * moved[body], 0.0) << i;
            }
            EXPECT_NEAR(loads[kOutput], path.torque()[kOutput], left) << i;
        }
    }
}

/// A break-away from stiction throws the capstan forward, and what its mass would carry is lost here: no balance with it.
Joint without_rest_excess(Joint joint) {
    joint.gear_friction[kAntagonist] = spring::FrictionLaw::affine(0.03, 0.2);
    return joint;
}

/// Work of the torques = energy stored + friction's, each by the trapezoidal rule. Its error falls with the square of the step; so does
/// that of the steps in which a body begins to slide: 4000 steps a stroke leave 1e-6 of the work.
TEST(StickSlip, EnergyBalances) {
    RandomJoint random(11);
    constexpr int kSteps = 4000;
    for (int i = 0; i < 6; ++i) {
        StickSlip path(i == 0 ? paper_joint() : without_rest_excess(random.antagonist()));
        path.lead_to({1.0, 1.0, 0.0});
        const Joint& joint = path.joint();
        const double start = energy(joint, path.z());
        double work = 0.0, spent = 0.0, lost = 0.0;
        for (int stroke = 0; stroke < 4; ++stroke) {
            const Vector3d from = path.torque(),
                           to = i == 0 ? Vector3d(1.0 + 0.2 * stroke, 1.3, 0.1 - 0.1 * stroke) : random_torque(random, joint.ratio());
            for (int k = 1; k <= kSteps; ++k) {
                const Vector3d z = path.z(), torque = path.torque(), loads = spring_torques(joint, z);
                path.lead_to(from + (to - from) * k / kSteps, 1);
                const Vector3d moved = path.z() - z, middle = 0.5 * (torque + path.torque()), after = spring_torques(joint, path.z());
                work += middle.dot(moved);
                spent += middle.cwiseProduct(moved).cwiseAbs().sum();
                for (const int body : {kAgonist, kAntagonist}) {
                    const spring::FrictionLaw& gear = joint.gear_friction[body];
                    lost += 0.5 * (gear.in_motion(loads[body]) + gear.in_motion(after[body])) * std::abs(moved[body]);
                }
            }
        }
        EXPECT_NEAR(work, energy(joint, path.z()) - start + lost, 1e-6 * spent) << i;
        EXPECT_GT(lost, 0.01 * spent) << i;
    }
}

/// While every body moves one way only, the end of a stroke does not depend on its steps.
TEST(StickSlip, MonotoneStrokesDoNotDependOnTheSteps) {
    for (const double push : {0.05, 0.3, 1.2}) {
        std::vector<Vector3d> ends;
        for (const int steps : {1, 3, 48, 500}) {
            StickSlip path(paper_joint());
            path.lead_to({1.0, 1.0, 0.0}, steps);
            path.lead_to({1.0, 1.0, push}, steps);
            path.lead_to({1.0, 1.0, 0.0}, steps);
            ends.push_back(path.z());
        }
        for (const Vector3d& end : ends) EXPECT_LT((end - ends.front()).cwiseAbs().maxCoeff(), kSolved) << push;
    }
}

/// A joint of two like sides answers a push to -q as it does one to +q, the capstans' parts exchanged.
TEST(StickSlip, LikeSidesAnswerAlike) {
    StickSlip up(paper_joint()), down(paper_joint());
    for (const double push : {0.0, 0.6, 0.0, -0.9, 0.0, 1.1, 0.0}) {
        up.lead_to({1.0, 1.0, push});
        down.lead_to({1.0, 1.0, -push});
        EXPECT_NEAR(up.z()[kOutput], -down.z()[kOutput], kSolved) << push;
        EXPECT_NEAR(up.z()[kAgonist], down.z()[kAntagonist], kSolved) << push;
        EXPECT_NEAR(up.z()[kAntagonist], down.z()[kAgonist], kSolved) << push;
    }
}

/// A cable can be pulled with no more than its capstan holds: beyond g tau/(1-mu) the joint runs away, which is said, and comes back.
TEST(StickSlip, RunawayIsSaid) {
    StickSlip held(paper_joint()), lost(paper_joint());
    const double most = 0.8 / (1.0 - kMu);
    for (auto* path : {&held, &lost}) {
        path->lead_to({0.8, 0.8, 0.0});
        path->lead_to({0.8, 0.8, (path == &held ? 0.99 : 1.3) * most});
        path->lead_to({0.8, 0.8, 0.0});
    }
    EXPECT_FALSE(lost.inside());
    EXPECT_NEAR(lost.z()[kOutput], held.z()[kOutput], kSolved);
}

TEST(StickSlip, LeavingALawIsSaid) {
    StickSlip path(paper_joint());
    path.lead_to({2.0, 2.0, 0.0});
    EXPECT_TRUE(path.inside());
    path.lead_to({2.21 * 1.3, 2.21 * 1.3, 0.0});
    EXPECT_FALSE(path.inside());
    path.lead_to({1.0, 1.0, 0.0});
    EXPECT_FALSE(path.inside());  // the path has been outside
}

TEST(StickSlip, RefusesWhatIsNoPath) {
    StickSlip path(paper_joint());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(path.lead_to({1.0, nan, 0.0}), core::InvalidInput);
    EXPECT_THROW(path.lead_to({1.0, 1.0, 0.0}, 0), core::InvalidInput);
    EXPECT_EQ(field_refused([&] { path.lead_to({1.0, 1.0, nan}); }), "torque[2]");
    EXPECT_EQ(path.torque(), Vector3d::Zero());
}

}  // namespace
}  // namespace fusee::actuator
