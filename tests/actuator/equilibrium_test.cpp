#include "fusee/actuator/equilibrium.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <limits>

#include "fusee/core/error.h"
#include "random_joint.h"

namespace fusee::actuator {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

double largest(const Vector3d& v) { return v.lpNorm<Eigen::Infinity>(); }

Joint linear_joint(double p1, double s2, double s3, double p4, double ratio) {
    const auto spring = [](double rate) { return spring::make_polynomial({0.0, rate}); };
    return antagonist(spring(p1), spring(s2), spring(s3), spring(p4),
                      {spring::FrictionLaw::proportional(0.0), spring::FrictionLaw::proportional(0.0)}, 0.02, 0.02 * ratio);
}

/// Any three torques, whether the springs bear them or not.
Vector3d any_torque(RandomJoint& random) { return {random.within(-0.2, 3.0), random.within(-0.2, 3.0), random.within(-1.5, 1.5)}; }
Vector3d any_start(RandomJoint& random) { return {random.within(-5.0, 5.0), random.within(-5.0, 5.0), random.within(-5.0, 5.0)}; }

Vector3d torque_in(const std::string& suggestion) {
    Vector3d t = Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(std::sscanf(suggestion.c_str(), "tau_1 = %lf Nm, tau_2 = %lf Nm, tau_q = %lf Nm", &t[0], &t[1], &t[2]), 3) << suggestion;
    return t;
}

TEST(Equilibrium, LinearSpringsAreKnownByHand) {
    // P theta + S (theta +- g q) = tau on both sides, g S (2 g q) + ... = tau_q: at q the sides share what the output is pushed by.
    const double p = 0.3, s = 0.5, g = 1.5;
    const auto rest = find_equilibrium(linear_joint(p, s, s, p, g), {1.0, 1.0, 0.0});
    ASSERT_TRUE(rest);
    EXPECT_NEAR(rest->z[0], 1.0 / (p + s), 1e-14);
    EXPECT_NEAR(rest->z[1], 1.0 / (p + s), 1e-14);
    EXPECT_NEAR(rest->z[2], 0.0, 1e-14);
    const auto pushed = find_equilibrium(linear_joint(p, s, s, p, g), {1.0, 1.0, 0.2});
    ASSERT_TRUE(pushed);
    EXPECT_NEAR(pushed->z[2], 0.2 / (2.0 * g * g * s * p / (s + p)), 1e-14);  // dead_band.md (12), free capstans
    EXPECT_NEAR(pushed->z[0], (1.0 - s * g * pushed->z[2]) / (p + s), 1e-14);
}

/// Footnote 2: where stiffness is >= 0 there is one resting place for any start.
TEST(Equilibrium, IsFoundFromAnyStartOnTenThousandActuators) {
    RandomJoint random(31);
    for (int i = 0; i < 10000; ++i) {
        const Joint joint = random.antagonist();
        const Vector3d place = random.place(joint), torque = spring_torques(joint, place);
        ASSERT_TRUE(outside(joint, place).empty()) << i;
        for (int start = 0; start < 2; ++start) {
            const auto rest = find_equilibrium(joint, torque, any_start(random));
            ASSERT_TRUE(rest) << i << ": " << core::to_line(rest.refusal().front());
            ASSERT_LE(rest->residual, 1e-9 * largest(torque)) << i;
            // A torque error of 1e-12 moves the place by at most its sensitivity.
            const double soft = sensitivity(joint, place).value().cwiseAbs().maxCoeff();
            ASSERT_LE(largest(rest->z - place), 1e-12 * (1.0 + soft * (1.0 + largest(torque)))) << i;
        }
    }
}

TEST(Equilibrium, AnyTorquesRestOnceOrAreRefusedOnce) {
    RandomJoint random(32);
    int found = 0, refused = 0;
    for (int i = 0; i < 10000; ++i) {
        const Joint joint = random.antagonist();
        const Vector3d torque = any_torque(random), start = any_start(random);
        const auto one = find_equilibrium(joint, torque, start), other = find_equilibrium(joint, torque, any_start(random));
        ASSERT_EQ(static_cast<bool>(one), static_cast<bool>(other)) << i;
        const auto bare = equilibrium(joint, torque, start);
        ASSERT_EQ(static_cast<bool>(one), bare.has_value()) << i;
        if (bare) {
            ASSERT_EQ(bare->z, one->z) << i;
        }
        if (one) {
            ++found;
            ASSERT_LE(one->residual, 1e-9 * largest(torque)) << i;
            const double soft = sensitivity(joint, one->z).value().cwiseAbs().maxCoeff();
            ASSERT_LE(largest(one->z - other->z), 1e-12 * (1.0 + soft * (1.0 + largest(torque)))) << i;
            continue;
        }
        ++refused;
        const core::Finding& finding = one.refusal().front();
        ASSERT_EQ(finding.rule, other.refusal().front().rule) << i;
        const Vector3d suggested = torque_in(finding.suggestion.text());
        ASSERT_TRUE(find_equilibrium(joint, suggested)) << i << ": " << core::to_line(finding);
    }
    EXPECT_GT(found, 1000);
    EXPECT_GT(refused, 1000);
}

TEST(Equilibrium, StartsWhereTorquesOverflowAreFarButNotLost) {
    const auto steep = [] { return spring::make_exponential(0.1, 20.0, 0.05); };  // e^2000 at the end of its domain
    const Joint joint = antagonist(steep(), steep(), steep(), steep(),
                                   {spring::FrictionLaw::proportional(0.0), spring::FrictionLaw::proportional(0.0)}, 0.02, 0.03);
    const auto near = find_equilibrium(joint, {1.0, 0.7, 0.1});
    ASSERT_TRUE(near);
    for (const Vector3d& start : {Vector3d(90.0, 90.0, 1.0), Vector3d(150.0, -3.0, 80.0), Vector3d(-1e5, 20.0, 1e4)}) {
        const auto far = find_equilibrium(joint, {1.0, 0.7, 0.1}, start);
        ASSERT_TRUE(far) << start.transpose();
        EXPECT_NEAR(largest(far->z - near->z), 0.0, 1e-13) << start.transpose();
    }
}

TEST(Equilibrium, FrozenBodiesStayAndNeedNoTorque) {
    Joint joint = linear_joint(0.3, 0.5, 0.5, 0.3, 1.0);
    joint.frozen = {false, true, false};
    const auto rest = find_equilibrium(joint, {1.0, 99.0, 0.0}, {0.0, 2.0, 0.0});
    ASSERT_TRUE(rest);
    EXPECT_EQ(rest->z[1], 2.0);
    const Vector3d held = spring_torques(joint, rest->z);
    EXPECT_NEAR(held[0], 1.0, 1e-14);
    EXPECT_NEAR(held[2], 0.0, 1e-14);
    const Matrix3d m = sensitivity(joint, rest->z).value();
    EXPECT_EQ(m.row(1).norm() + m.col(1).norm(), 0.0);
    EXPECT_NEAR(m(2, 2), 1.0 / (0.5 + 0.3 * 0.5 / (0.3 + 0.5)), 1e-14);
}

TEST(EquilibriumRefusal, SlackAndFreeMotionsAreNamedWithTorquesThatWork) {
    const Joint joint = linear_joint(0.3, 0.5, 0.5, 0.3, 1.5);
    const auto slack = find_equilibrium(joint, {0.5, 0.02, 0.6});  // the output is pulled towards an antagonist that hardly pulls
    ASSERT_FALSE(slack);
    EXPECT_EQ(slack.refusal().front().rule, "equilibrium.outside");
    EXPECT_EQ(slack.refusal().front().where, "K_SE antagonist");
    EXPECT_TRUE(find_equilibrium(joint, torque_in(slack.refusal().front().suggestion.text())));
    const auto loose = find_equilibrium(joint, {-0.5, 0.5, 0.0});  // a motor that pays out: nothing stops it
    ASSERT_FALSE(loose);
    EXPECT_EQ(loose.refusal().front().rule, "equilibrium.free");
    EXPECT_TRUE(find_equilibrium(joint, torque_in(loose.refusal().front().suggestion.text())));
}

/// Figure 1 with a = b = 0: the whole joint turns through.
TEST(EquilibriumRefusal, AJointThatFloatsIsFree) {
    Joint joint = linear_joint(0.3, 0.5, 0.5, 0.3, 1.0);
    joint.springs = {joint.springs[1], joint.springs[2]};
    for (const double push : {0.0, 0.1}) {
        const auto floating = find_equilibrium(joint, {1.0, 1.0, push});
        ASSERT_FALSE(floating);
        EXPECT_EQ(floating.refusal().front().rule, "equilibrium.free");
        EXPECT_NE(floating.refusal().front().suggestion.text().find("a spring to the ground"), std::string::npos);
        EXPECT_FALSE(sensitivity(joint, {1.0, 1.0, 0.0}));
    }
    joint.springs.push_back({"K_PE agonist", spring::make_polynomial({0.0, 0.2}), {1.0, 0.0, 0.0}, 0.0});
    EXPECT_TRUE(find_equilibrium(joint, {1.0, 0.7, 0.0}));
}

TEST(EquilibriumRefusal, ASofteningSpringIsNamedAndStiffeningItWorks) {
    const auto joint = [](double stiffer) {
        const auto soft = spring::make_polynomial({0.0, 0.4 + stiffer, -0.1});  // softens beyond 2 rad
        const auto stiff = spring::make_polynomial({0.0, 0.6});
        return antagonist(soft, stiff, stiff, stiff, {spring::FrictionLaw::proportional(0.0), spring::FrictionLaw::proportional(0.0)}, 0.02,
                          0.02);
    };
    EXPECT_TRUE(find_equilibrium(joint(0.0), {1.0, 1.0, 0.0}));
    const auto refused = find_equilibrium(joint(0.0), {2.2, 2.2, 0.0});
    ASSERT_FALSE(refused);
    const core::Finding& finding = refused.refusal().front();
    EXPECT_EQ(finding.rule, "equilibrium.convexity");
    EXPECT_LT(finding.measured, 0.0);
    double higher = 0.0;
    ASSERT_EQ(std::sscanf(finding.suggestion.text().c_str(), "a spring whose stiffness is higher by %lf Nm/rad", &higher), 1);
    EXPECT_TRUE(find_equilibrium(joint(higher), {2.2, 2.2, 0.0}));
}

/// A rigid stop: its torque jumps from 0.1 to 1.1 Nm at 1 rad.
class Jump final : public spring::Potential {
public:
    [[nodiscard]] core::Range domain() const override { return {0.0, 10.0}; }
    [[nodiscard]] double energy(double x) const override { return 0.05 * x * x + std::max(0.0, x - 1.0); }
    [[nodiscard]] double force(double x) const override { return 0.1 * x + (x > 1.0 ? 1.0 : 0.0); }
    [[nodiscard]] double stiffness(double /*x*/) const override { return 0.1; }
    [[nodiscard]] double slope(double /*x*/) const override { return 0.0; }
};

TEST(EquilibriumRefusal, ATorqueThatJumpsIsSaid) {
    Joint joint = linear_joint(0.3, 0.5, 0.5, 0.3, 1.0);
    joint.springs.push_back({"stop", std::make_shared<Jump>(), Vector3d::UnitX(), 0.0});
    EXPECT_TRUE(find_equilibrium(joint, {0.5, 0.5, 0.0}));
    const auto refused = find_equilibrium(joint, {1.3, 1.3, 0.0});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.refusal().front().rule, "equilibrium.convexity");
    EXPECT_GT(refused.refusal().front().measured, 0.1);  // Nm that nothing holds
}

TEST(EquilibriumRefusal, NumbersMustBeFinite) {
    const Joint joint = linear_joint(0.3, 0.5, 0.5, 0.3, 1.0);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW((void)find_equilibrium(joint, {1.0, nan, 0.0}), core::InvalidInput);
    EXPECT_THROW((void)find_equilibrium(joint, {1.0, 1.0, 0.0}, {0.0, 0.0, 1.0 / 0.0}), core::InvalidInput);
}

/// Fourth-order central difference of find_equilibrium by one torque.
Vector3d difference(const Joint& joint, const Vector3d& torque, int by, const Vector3d& start, double h) {
    const auto at = [&](double share) {
        Vector3d changed = torque;
        changed[by] += share * h;
        return find_equilibrium(joint, changed, start).value().z;
    };
    return (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * h);
}

TEST(Sensitivity, IsTheSlopeOfTheEquilibriumOnAThousandActuators) {
    RandomJoint random(33);
    for (int i = 0; i < 1000; ++i) {
        const Joint joint = random.antagonist();
        const Vector3d place = random.place(joint), torque = spring_torques(joint, place);
        const Matrix3d m = sensitivity(joint, place).value();
        const double most = m.cwiseAbs().maxCoeff();
        // Far enough not to drown in rounding, near enough for every place to stay within its law.
        const double h = 1e-3 / most;
        for (int by = 0; by < 3; ++by) {
            const Vector3d slope = difference(joint, torque, by, place, h);
            // An entry far below the largest drowns in that one's rounding.
            for (int body = 0; body < 3; ++body)
                ASSERT_NEAR(slope[body], m(body, by), 1e-6 * std::max(std::abs(m(body, by)), 1e-3 * most)) << i << " " << by << body;
        }
        ASSERT_LE((m - m.transpose()).cwiseAbs().maxCoeff(), 1e-12 * most) << i;  // Maxwell's reciprocity
    }
}

/// The paper's closed form of (2) for the antagonist, hats on, in the signs of Joint: from the four stiffnesses U_i'' [N/m along the
/// cable].
Matrix3d closed_sensitivity(double u1, double u2, double u3, double u4) {
    const double determinant = u1 * u2 * u3 + u1 * u2 * u4 + u1 * u3 * u4 + u2 * u3 * u4;
    const double side_1 = u1 + u2, side_2 = u3 + u4;
    Matrix3d m;
    m << u2 * u3 + u2 * u4 + u3 * u4, -u2 * u3, -u2 * side_2,  //
        -u2 * u3, u1 * u2 + u1 * u3 + u2 * u3, u3 * side_1,    //
        -u2 * side_2, u3 * side_1, side_1 * side_2;
    return m / determinant;
}

/// Hats on: stiffness along the cable is U''/r_c^2, and the inverse of the paper's matrix has a closed form.
TEST(Sensitivity, IsThePapersClosedForm) {
    RandomJoint random(34);
    for (int i = 0; i < 1000; ++i) {
        const Joint joint = random.antagonist();
        const Vector3d place = random.place(joint);
        std::array<double, 4> u{};
        const std::array<double, 4> x{place[0], place[0] + joint.ratio() * place[2], place[1] - joint.ratio() * place[2], place[1]};
        for (std::size_t s = 0; s < 4; ++s)
            u[s] = joint.springs[s].potential->stiffness(x[s]) / (joint.capstan_radius * joint.capstan_radius);
        const Matrix3d closed = closed_sensitivity(u[0], u[1], u[2], u[3]), inverse = cable_space(sensitivity(joint, place).value(), joint);
        // The closed form adds positive terms only; the inverse loses as many digits as the stiffest spring has over the softest (to 1e6).
        ASSERT_LE((closed - inverse).cwiseAbs().maxCoeff(), 1e-9 * closed.cwiseAbs().maxCoeff()) << i;
        // The two ratios after P(3), the agonist's with the sign of the joint's own counting.
        ASSERT_NEAR(closed(2, 0) / closed(2, 2), -u[1] / (u[0] + u[1]), 1e-14);
        ASSERT_NEAR(closed(2, 1) / closed(2, 2), u[2] / (u[2] + u[3]), 1e-14);
    }
}

TEST(Sensitivity, CapstanEntryIsP13AndP14IsExactAtEqualCoContraction) {
    const double u1 = 2.0, u2 = 3.0, u3 = 5.0, u4 = 7.0;
    const Matrix3d m = closed_sensitivity(u1, u2, u3, u4);
    EXPECT_NEAR(m(1, 1), (u1 * u2 + u1 * u3 + u2 * u3) / (u1 * u2 * u3 + u1 * u2 * u4 + u1 * u3 * u4 + u2 * u3 * u4), 1e-16);
    // An infinitely stiff agonist, as the paper argues ...
    EXPECT_NEAR(closed_sensitivity(1e12, 1e12, u3, u4)(1, 1), 1.0 / (u3 + u4), 1e-12);
    // ... but no approximation is needed: both torques raised equally leave the joint where it is.
    const Matrix3d even = closed_sensitivity(u4, u3, u3, u4);
    EXPECT_NEAR(even(1, 0) + even(1, 1), 1.0 / (u3 + u4), 1e-16);
    EXPECT_NEAR(even(2, 0) + even(2, 1), 0.0, 1e-16);
}

}  // namespace
}  // namespace fusee::actuator
