#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "actuator/random_joint.h"
#include "actuator/with_law.h"
#include "fusee/actuator/dead_band.h"
#include "fusee/actuator/stick_slip.h"
#include "fusee/core/error.h"
#include "fusee/math/roots.h"
#include "fusee/spring/laws.h"
#include "fusee/spring/potential.h"

namespace fusee::actuator {
namespace {

spring::SpringLawPtr paper_law() {
    return *spring::make_stiction_law({.k = 0.225, .u = 0.0012, .c = 0.265, .mu = kMu, .start_torque = 0.6, .end_torque = 2.21});
}

/// The first prototype's, up to load `end`.
spring::SpringLawPtr prototype_law_to(double end) {
    return *spring::make_pair_law(spring::make_polynomial({0.0, 0.10, 0.02}), spring::make_polynomial({0.0, 0.25, 0.03}), 0.06, end);
}

/// A stiff K_SE (T = 0.6) that reaches far: both capstans slide back before the joint comes to rest.
spring::SpringLawPtr linear_law() {
    return *spring::make_pair_law(spring::make_polynomial({0.0, 0.6}), spring::make_polynomial({0.0, 0.4}), 0.01, 20.0);
}

/// docs/theory/stick_slip.md, eq. 8: the reading of a full push from the law alone. The capstan that wound in while its cable hung loose
/// stands where K_PE carries L_low; the other one slides back to L_low.
double loose_cable_width(const Actuator& actuator, double tau) {
    const spring::SpringLaw& law = *actuator.law;
    const double low = actuator.gear_friction.resting_loads(tau).low;
    const double theta_high = *math::bracketed_root([&](double at) { return law.at_angle(at).f_pe - low; }, 0.0, law.angles().high);
    const double theta_low = *math::bracketed_root(
        [&](double at) { return law.at_angle(at).f_pe + law.at_angle(0.5 * (at + theta_high)).f_se - low; }, 0.0, theta_high);
    return (theta_high - theta_low) / actuator.ratio();
}

TEST(ReleaseTest, AFullPushReadsTheExactExtremeWhereBothCapstansSlideBack) {
    for (const double mu : {0.05, 0.15, 0.25}) {
        for (const double ratio : {0.7, 1.5}) {
            const Actuator actuator = with_law(linear_law(), mu, ratio);
            const ReleaseReading reading = release_test(joint_of(actuator), 1.0);
            EXPECT_TRUE(reading.inside);
            EXPECT_TRUE(reading.strong_enough());
            EXPECT_NEAR(reading.width(), dead_band(actuator, 1.0).exact_width, 1e-8) << mu;
            EXPECT_NEAR(reading.q_high, -reading.q_low, 1e-8) << mu;
        }
    }
}

/// With a soft K_SE the cable of the capstan that winds in hangs loose before a stronger push can turn it farther, and its load never
/// comes to the limit at which it would slide back: the reading stays inside the exact extreme, however strong the push.
TEST(ReleaseTest, ALooseCableKeepsTheReadingInsideTheExtreme) {
    const Actuator actuator = with_law(paper_law());
    const double exact = dead_band(actuator, 1.0).exact_width;
    const Joint joint = joint_of(actuator);
    for (const double push : {1.25, 1.3, 5.0}) {  // 5 Nm: more than the gears hold
        const ReleaseReading reading = release_test(joint, 1.0, {.push_torque = push});
        EXPECT_FALSE(reading.inside);  // K_SE is stretched beyond its law
        EXPECT_NEAR(reading.width(), loose_cable_width(actuator, 1.0), 1e-7) << push;
        EXPECT_NEAR(reading.width(), 0.81 * exact, 0.01 * exact) << push;
    }
}

/// Wherever the laws end: what a full push reads is the loose cable's doing, and a law that ends before is continued straight, which is
/// said.
TEST(ReleaseTest, AFullPushReadsTheSameWhereverTheLawsEnd) {
    int left = 0, kept = 0;
    for (double end = 1.1; end < 1.6; end += 0.005) {
        const Actuator actuator = with_law(prototype_law_to(end));
        const ReleaseReading reading = release_test(joint_of(actuator), 0.5);
        EXPECT_TRUE(reading.strong_enough()) << end;
        EXPECT_NEAR(reading.width(), loose_cable_width(actuator, 0.5), 1.1e-3 * reading.width()) << end;
        EXPECT_EQ(reading.inside, reading.covered_push >= reading.push_torque) << end;
        ++(reading.inside ? kept : left);
    }
    EXPECT_GT(left, 0);
    EXPECT_GT(kept, 0);
}

/// For any springs, gears and pushes the reading is a place where the joint can rest.
TEST(ReleaseTest, ReadsWithinTheExactExtreme) {
    RandomJoint random(5);
    int covered = 0, wide = 0;
    for (int i = 0; i < 300; ++i) {
        const Joint joint = random.antagonist();
        const double tau = random.within(0.3, 1.5);
        const JointDeadBand exact = joint_dead_band(joint, tau, tau);
        if (!exact.covered) continue;
        ++covered;
        const double push = joint.ratio() * tau * random.within(0.05, 0.95);
        const ReleaseReading reading = release_test(joint, tau, {.push_torque = push, .find_full_push = false});
        EXPECT_GE(reading.q_low, exact.edges.low - 1e-8) << i;
        EXPECT_LE(reading.q_high, exact.edges.high + 1e-8) << i;
        if (reading.width() > 0.9 * exact.exact_width) ++wide;
    }
    EXPECT_GT(covered, 50);
    EXPECT_GT(wide, 5);
    EXPECT_LT(wide, covered - 5);
}

TEST(ReleaseTest, AWeakPushReadsLessAndSaysSo) {
    const Actuator actuator = with_law(linear_law());
    const Joint joint = joint_of(actuator);
    const ReleaseReading full = release_test(joint, 1.0);
    double earlier = 0.0;
    for (const double share : {0.1, 0.3, 0.6, 0.9}) {
        const ReleaseReading weak = release_test(joint, 1.0, {.push_torque = share * full.full_push});
        EXPECT_FALSE(weak.strong_enough());
        EXPECT_NEAR(weak.full_push, full.full_push, 1e-12);
        EXPECT_GT(weak.width(), 1.05 * earlier) << share;
        EXPECT_LT(weak.width(), 0.98 * full.width()) << share;
        earlier = weak.width();
    }
    const ReleaseReading strong = release_test(joint, 1.0, {.push_torque = 1.01 * full.full_push});
    EXPECT_TRUE(strong.strong_enough());
    EXPECT_NEAR(strong.width(), full.width(), 1.5e-3 * full.width());  // full means: to 0.1 %
}

/// Linear springs: the stretched capstan stays, the other winds in to theta_2 = (L_low + S g q_p)/(S + P) while the joint goes to
/// q_p = push/(g^2 S (1 + P/(S + P))), and both stay on the way back.
TEST(ReleaseTest, AWeakPushIsKnownForLinearSprings) {
    const double s = 0.6, p = 0.4, g = 1.5, push = 0.05, tau = 1.0, low = tau / (1.0 + kMu);
    const ReleaseReading reading = release_test(joint_of(with_law(linear_law(), kMu, g)), tau, {.push_torque = push});
    const double theta_1 = low / (s + p), q_pushed = push / (g * g * s * (1.0 + p / (s + p)));
    const double theta_2 = (low + s * g * q_pushed) / (s + p);
    EXPECT_NEAR(reading.q_high, (theta_2 - theta_1) / (2.0 * g), 1e-9);
    EXPECT_LT(reading.q_high, q_pushed);
    EXPECT_FALSE(reading.strong_enough());
}

/// The paper's springs end before a push is full: the push that the laws cover is reported too.
TEST(ReleaseTest, SpringsThatEndFirstTellWhatTheyBear) {
    const Joint joint = joint_of(with_law(paper_law()));
    for (const double tau : {0.8, 1.0, 1.5}) {
        const ReleaseReading reading = release_test(joint, tau);
        EXPECT_TRUE(reading.strong_enough()) << tau;
        EXPECT_FALSE(reading.inside) << tau;
        EXPECT_GT(reading.covered_push, 0.0) << tau;
        EXPECT_LT(reading.covered_push, 0.6 * reading.full_push) << tau;
        EXPECT_TRUE(release_test(joint, tau, {.push_torque = reading.covered_push}).inside) << tau;
        EXPECT_FALSE(release_test(joint, tau, {.push_torque = 1.01 * reading.covered_push}).inside) << tau;
    }
}

TEST(ReleaseTest, CoContractionBeyondTheLawReadsNothing) {
    const ReleaseReading reading = release_test(joint_of(with_law(paper_law())), 4.0);
    EXPECT_FALSE(reading.inside);
    EXPECT_EQ(reading.push_torque, 0.0);
    EXPECT_TRUE(std::isnan(reading.full_push));
    EXPECT_TRUE(std::isnan(reading.width()));
}

TEST(ReleaseTest, ReadsTheSameWithoutLookingForTheFullPush) {
    const Joint joint = joint_of(with_law(linear_law()));
    const ReleaseReading plain = release_test(joint, 1.0, {.push_torque = 0.4, .find_full_push = false});
    const ReleaseReading whole = release_test(joint, 1.0, {.push_torque = 0.4});
    EXPECT_TRUE(std::isnan(plain.full_push));
    EXPECT_FALSE(plain.strong_enough());
    EXPECT_GT(whole.full_push, 0.4);
    EXPECT_EQ(plain.q_low, whole.q_low);
    EXPECT_EQ(plain.q_high, whole.q_high);
}

/// The paper's frame subsystem: masses in place of motors. Without bearing friction nothing holds the joint off its middle; with a
/// constant one it rests within 2 c/(free stiffness), which co-contraction makes vanish.
TEST(ReleaseTest, FrameSubsystemHasNoDeadBandButItsBearings) {
    const Actuator actuator = with_law(paper_law());
    Joint frame = joint_of(actuator, false);
    for (const double tau : {0.8, 1.5}) EXPECT_NEAR(release_test(frame, tau).width(), 0.0, 1e-9) << tau;
    frame.output_friction.constant = 1e-4;  // so small that the stiffness hardly changes within the dead-band
    double earlier = std::numeric_limits<double>::infinity();
    for (const double tau : {0.8, 1.0, 1.25, 1.5, 1.8}) {
        const ReleaseReading reading = release_test(frame, tau);
        const double known = 2.0 * frame.output_friction.constant / dead_band(actuator, tau).free_joint_stiffness;
        EXPECT_NEAR(reading.width(), known, 1e-4 * known) << tau;
        EXPECT_TRUE(reading.strong_enough()) << tau;
        EXPECT_LT(reading.width(), 0.9 * earlier) << tau;
        earlier = reading.width();
    }
}

/// The first prototype's dead-band grows with co-contraction, the new springs' shrinks: in the reading as in the exact width.
TEST(ReleaseTest, FirstPrototypeGrowsAndNewSpringsShrink) {
    const Joint old_joint = joint_of(with_law(prototype_law_to(1.65))), new_joint = joint_of(with_law(paper_law()));
    const auto width = [](const Joint& joint, double tau, double push) { return release_test(joint, tau, {.push_torque = push}).width(); };
    EXPECT_GT(width(old_joint, 0.5, 0.65), 1.5 * width(old_joint, 0.25, 0.33));
    EXPECT_GT(width(old_joint, 1.0, 1.3), 1.5 * width(old_joint, 0.5, 0.65));
    EXPECT_LT(width(new_joint, 1.5, 2.0), 0.5 * width(new_joint, 1.0, 1.3));
}

TEST(ReleaseTest, HardlyDependsOnItsSteps) {
    const Joint joint = joint_of(with_law(linear_law()));
    const ReleaseReading coarse = release_test(joint, 1.0, {.push_torque = 0.5, .steps = 2});
    const ReleaseReading fine = release_test(joint, 1.0, {.push_torque = 0.5, .steps = 200});
    EXPECT_NEAR(coarse.q_high, fine.q_high, 1e-9);
    EXPECT_NEAR(coarse.q_low, fine.q_low, 1e-9);
}

TEST(ReleaseTest, RefusesWhatIsNoTest) {
    const Joint joint = joint_of(with_law(linear_law()));
    EXPECT_THROW((void)release_test(joint, 0.0), core::InvalidInput);
    EXPECT_THROW((void)release_test(joint, 1.0, {.push_torque = -0.1}), core::InvalidInput);
    EXPECT_THROW((void)release_test(joint, 1.0, {.steps = 0}), core::InvalidInput);
}

}  // namespace
}  // namespace fusee::actuator
