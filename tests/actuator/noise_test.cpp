#include "fusee/actuator/noise.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>
#include <unsupported/Eigen/MatrixFunctions>

#include "fusee/core/error.h"
#include "fusee/spring/laws.h"

namespace fusee::actuator {
namespace {

using Eigen::MatrixXd;

class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    double between(double low, double high) { return std::uniform_real_distribution(low, high)(engine_); }
    /// Evenly spread over the decades.
    double decades(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
    double normal() { return std::normal_distribution()(engine_); }
    /// Symmetric, eigenvalues >= least.
    MatrixXd positive(Eigen::Index n, double least) {
        const MatrixXd root = MatrixXd::NullaryExpr(n, n, [this] { return normal(); });
        return root * root.transpose() + least * MatrixXd::Identity(n, n);
    }
    NoisePath path() {
        return {.a = decades(0.01, 10.0),
                .b = decades(0.01, 10.0),
                .c = decades(0.01, 10.0),
                .d = decades(0.01, 1.0),
                .e = decades(0.01, 1.0),
                .motor_inertia = decades(0.1, 10.0),
                .joint_inertia = decades(0.1, 10.0),
                .motor_noise = decades(0.01, 1.0),
                .joint_noise = decades(0.01, 1.0)};
    }

private:
    std::mt19937_64 engine_;
};

/// Noise in proportion to each damper, N = 2 T D: both bodies at one temperature.
NoisePath at_one_temperature(NoisePath path, double temperature) {
    path.motor_noise = 2.0 * temperature * path.d;
    path.joint_noise = 2.0 * temperature * path.e;
    return path;
}

double joint_variance(const NoisePath& path) { return passive_noise(path)->joint_variance; }

/// The joint's variance by the integral over all frequencies of a rational spectrum of fourth order (James, Nichols & Phillips, Theory of
/// Servomechanisms, 1947, appendix): no Lyapunov equation.
double variance_by_frequency(const NoisePath& p) {
    const double m = p.motor_inertia, big = p.joint_inertia, ac = p.a + p.c, bc = p.b + p.c;
    const double a4 = m * big, a3 = m * p.e + big * p.d, a2 = m * bc + big * ac + p.d * p.e, a1 = p.d * bc + p.e * ac,
                 a0 = p.a * p.b + p.c * (p.a + p.b);
    const double hurwitz = a1 * a2 * a3 - a0 * a3 * a3 - a1 * a1 * a4, inner = a2 * a3 - a1 * a4;
    const double motor = p.c * p.c * inner / (2.0 * a0 * hurwitz);
    const double joint =
        (m * m * a0 * a1 * a4 + (p.d * p.d - 2.0 * m * ac) * a0 * a3 * a4 + ac * ac * a4 * inner) / (2.0 * a0 * a4 * hurwitz);
    return p.motor_noise * motor + p.joint_noise * joint;
}

TEST(StationaryCovariance, OneMassIsKnown) {
    const double m = 0.3, d = 0.07, k = 2.5, n = 0.02;
    const auto x = stationary_covariance(MatrixXd::Constant(1, 1, m), MatrixXd::Constant(1, 1, d), MatrixXd::Constant(1, 1, k),
                                         MatrixXd::Constant(1, 1, n));
    ASSERT_TRUE(x);
    EXPECT_NEAR((*x)(0, 0), n / (2.0 * d * k), 1e-14);
    EXPECT_NEAR((*x)(1, 1), n / (2.0 * d * m), 1e-14);
    EXPECT_NEAR((*x)(0, 1), 0.0, 1e-15);
}

TEST(StationaryCovariance, SolvesTheLyapunovEquation) {
    Random random(1);
    for (Eigen::Index n = 1; n <= 6; ++n) {
        const MatrixXd m = random.positive(n, 0.5), d = random.positive(n, 0.1), k = random.positive(n, 0.1), q = random.positive(n, 0.0);
        const auto x = stationary_covariance(m, d, k, q);
        ASSERT_TRUE(x) << n;
        MatrixXd a = MatrixXd::Zero(2 * n, 2 * n), noise = a;
        a.topRightCorner(n, n).setIdentity();
        a.bottomLeftCorner(n, n) = -m.inverse() * k;
        a.bottomRightCorner(n, n) = -m.inverse() * d;
        noise.bottomRightCorner(n, n) = m.inverse() * q * m.inverse();
        const double scale = (a * *x).norm() + noise.norm();
        EXPECT_LT((a * *x + *x * a.transpose() + noise).norm(), 1e-12 * scale) << n;  // measured 1e-14
        EXPECT_GT(Eigen::SelfAdjointEigenSolver<MatrixXd>(*x).eigenvalues()(0), 0.0) << n;
    }
}

// Noise in proportion to damping is heat: every spring then holds T/2 for any masses (equipartition), covariance T K^-1.
TEST(StationaryCovariance, AtOneTemperatureItIsTheCompliance) {
    Random random(2);
    for (Eigen::Index n = 1; n <= 5; ++n) {
        const MatrixXd m = random.positive(n, 0.5), d = random.positive(n, 0.1), k = random.positive(n, 0.1);
        const auto x = stationary_covariance(m, d, k, 2.0 * 0.3 * d);
        ASSERT_TRUE(x) << n;
        const MatrixXd compliance = 0.3 * k.inverse();
        EXPECT_LT((x->topLeftCorner(n, n) - compliance).norm(), 1e-11 * compliance.norm()) << n;  // times the condition of K, below 100
    }
}

TEST(PassiveNoise, AgreesWithTheIntegralOverFrequencies) {
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const NoisePath path = random.path();
        const double known = variance_by_frequency(path);
        ASSERT_NEAR(joint_variance(path), known, 1e-9 * known) << i;  // the closed form's differences cancel up to four digits
    }
}

TEST(PassiveNoise, DoesNotDependOnTheUnits) {
    // In mm-like units (lengths 1e3, masses 1e-6) the same system: the variance scales exactly.
    const NoisePath path = Random(4).path();
    NoisePath tiny = path;
    for (double* stiff : {&tiny.a, &tiny.b, &tiny.c, &tiny.d, &tiny.e, &tiny.motor_inertia, &tiny.joint_inertia}) *stiff *= 1e-6;
    EXPECT_NEAR(joint_variance(tiny) * 1e-12 / joint_variance(path), 1.0, 1e-12);
}

// As the paper says: the joint is quieter the stiffer c is. It holds exactly where both bodies have one temperature (noise over damping):
// variance T (a + c)/(ab + ac + bc), slope -T a^2/(ab + ac + bc)^2. Without the spring a to ground a stiffer c gains nothing.
TEST(PassiveNoise, FallsWithCAtOneTemperature) {
    Random random(5);
    for (int i = 0; i < 500; ++i) {
        const double temperature = random.decades(0.01, 1.0);
        const NoisePath path = at_one_temperature(random.path(), temperature);
        const double sum = path.a * path.b + path.a * path.c + path.b * path.c;
        const double variance = temperature * (path.a + path.c) / sum, slope = -temperature * path.a * path.a / (sum * sum);
        ASSERT_NEAR(joint_variance(path), variance, 1e-10 * variance);
        // Slope and variance may differ by five decades; what is lost is counted from the variance over c.
        ASSERT_NEAR(*joint_variance_slope(path), slope, 1e-10 * (std::abs(slope) + variance / path.c));
    }
    NoisePath hanging = at_one_temperature(random.path(), 0.2);
    hanging.a = 0.0;
    for (const double c : {0.1, 1.0, 10.0}) {
        hanging.c = c;
        EXPECT_NEAR(joint_variance(hanging), 0.2 / hanging.b, 1e-12 / hanging.b);
    }
}

// Where it does not hold: noise at the motor alone reaches the joint only through c.
TEST(PassiveNoise, RisesWithCIfTheMotorAloneIsNoisy) {
    NoisePath path{.a = 1.0, .b = 1.0, .d = 0.5, .e = 0.5, .motor_inertia = 1.0, .joint_inertia = 1.0, .motor_noise = 1.0};
    double earlier = 0.0;
    for (const double c : {0.01, 0.03, 0.1, 0.3}) {
        path.c = c;
        EXPECT_GT(joint_variance(path), earlier);
        EXPECT_GT(*joint_variance_slope(path), 0.0);
        earlier = joint_variance(path);
    }
    // A rigid c leaves one body: N/(2 (d + e)(a + b)).
    path.c = 1e6;
    EXPECT_NEAR(joint_variance(path), 1.0 / (2.0 * 1.0 * 2.0), 1e-5);  // of order 1/c
}

// And with noise at the joint alone: a light motor on a soft c is a tuned damper, and stiffening c detunes it.
TEST(PassiveNoise, HasALeastVarianceAtATunedMotor) {
    NoisePath path{.a = 0.0, .b = 1.0, .c = 0.1, .d = 0.05, .e = 0.001, .motor_inertia = 0.05, .joint_inertia = 1.0, .joint_noise = 0.002};
    const double tuned = joint_variance(path);
    path.c = 0.01;
    EXPECT_NEAR(joint_variance(path) / tuned, 43.3, 0.1);
    EXPECT_LT(*joint_variance_slope(path), 0.0);
    path.c = 1.0;
    EXPECT_NEAR(joint_variance(path) / tuned, 1.71, 0.01);
    EXPECT_GT(*joint_variance_slope(path), 0.0);
}

TEST(PassiveNoise, SlopeIsTheDifferenceQuotient) {
    Random random(6);
    for (int i = 0; i < 200; ++i) {
        NoisePath path = random.path();
        const double slope = *joint_variance_slope(path), variance = joint_variance(path), c = path.c, h = 1e-4 * c;
        path.c = c + h;
        const double more = joint_variance(path);
        path.c = c - h;
        // Relative step 1e-4: its square times the third derivative, and 1e-12 of the variance over the step.
        ASSERT_NEAR(slope, (more - joint_variance(path)) / (2.0 * h), 1e-5 * variance / c) << i;
    }
}

TEST(PassiveNoise, UnboundedWithoutAPathToGround) {
    NoisePath path{.c = 1.0, .d = 0.1, .e = 0.1, .motor_inertia = 1.0, .joint_inertia = 2.0, .motor_noise = 1.0, .joint_noise = 1.0};
    const auto refused = passive_noise(path);
    ASSERT_FALSE(refused);
    const core::Finding& finding = refused.refusal().front();
    EXPECT_EQ(finding.rule, "noise.unbounded");
    EXPECT_EQ(finding.where, "motion: motor 1, joint 1");
    EXPECT_EQ(finding.allowed, 0.01) << "the suggested stiffness";
    EXPECT_LT(finding.measured, 1e-12);
    EXPECT_NE(finding.suggestion.text().find("0.01 Nm/rad between"), std::string::npos) << finding.suggestion.text();
    path.b = 0.01;
    EXPECT_TRUE(passive_noise(path));
    path.c = 0.0;  // the motor by itself
    ASSERT_FALSE(passive_noise(path));
    EXPECT_EQ(passive_noise(path).refusal().front().where, "motion: motor 1, joint 0");
    EXPECT_FALSE(joint_variance_slope(path));
}

TEST(PassiveNoise, UnboundedWithoutADamper) {
    NoisePath path{.a = 1.0, .b = 2.0, .c = 3.0, .motor_inertia = 1.0, .joint_inertia = 1.0, .joint_noise = 1.0};
    ASSERT_FALSE(passive_noise(path));
    EXPECT_EQ(passive_noise(path).refusal().front().unit, "Nms/rad");
    path.e = 0.1;  // one damper reaches both motions
    EXPECT_TRUE(passive_noise(path));
    // But not the motion in which its body stands still: two motors on one joint, swinging against each other.
    const MatrixXd mass = MatrixXd::Identity(3, 3), damping = Eigen::Vector3d(0.0, 0.0, 0.2).asDiagonal();
    MatrixXd stiffness(3, 3);
    stiffness << 2, 0, -1, 0, 2, -1, -1, -1, 3;
    const auto refused = stationary_covariance(mass, damping, stiffness, mass);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.refusal().front().where.find("z[2]"), std::string::npos);
    EXPECT_NE(refused.refusal().front().where.find("-1"), std::string::npos) << refused.refusal().front().where;
}

/// z(t + h) = F z(t) + noise exactly: F = exp(A h), the noise's covariance by Van Loan (1978), from one matrix exponential. Neither knows
/// of the Lyapunov equation.
struct Sampled {
    Eigen::Matrix4d transition, noise_root;
    Sampled(const NoisePath& p, double h) {
        Eigen::Matrix4d a = Eigen::Matrix4d::Zero(), q = Eigen::Matrix4d::Zero();
        a.topRightCorner<2, 2>().setIdentity();
        a.row(2) << -(p.a + p.c) / p.motor_inertia, p.c / p.motor_inertia, -p.d / p.motor_inertia, 0.0;
        a.row(3) << p.c / p.joint_inertia, -(p.b + p.c) / p.joint_inertia, 0.0, -p.e / p.joint_inertia;
        q(2, 2) = p.motor_noise / (p.motor_inertia * p.motor_inertia);
        q(3, 3) = p.joint_noise / (p.joint_inertia * p.joint_inertia);
        Eigen::Matrix<double, 8, 8> block;
        block << -a, q, Eigen::Matrix4d::Zero(), a.transpose();
        const Eigen::Matrix<double, 8, 8> e = (block * h).exp();
        transition = e.bottomRightCorner<4, 4>().transpose();
        const Eigen::Matrix4d covariance = transition * e.topRightCorner<4, 4>();
        noise_root = Eigen::Matrix4d(0.5 * (covariance + covariance.transpose())).llt().matrixL();
    }
};

TEST(PassiveNoise, AgreesWithATimeSimulation) {
    constexpr int kSteps = 200000;
    constexpr double kStep = 0.4;  // [s]; discretised exactly, so that it may be coarse
    const NoisePath path{.a = 1.0,
                         .b = 0.3,
                         .c = 2.0,
                         .d = 0.4,
                         .e = 0.6,
                         .motor_inertia = 0.5,
                         .joint_inertia = 1.5,
                         .motor_noise = 0.2,
                         .joint_noise = 0.1};
    const NoiseResponse expected = *passive_noise(path);
    const Sampled sampled(path, kStep);
    Random random(7);
    Eigen::Vector4d z = Eigen::Vector4d::Zero(), squares = z;
    for (int i = -1000; i < kSteps; ++i) {  // 400 s let the start be forgotten: the slowest decay is 0.2/s
        z = sampled.transition * z + sampled.noise_root * Eigen::Vector4d::NullaryExpr([&] { return random.normal(); });
        if (i >= 0) squares += z.cwiseAbs2();
    }
    // A variance estimated from correlated Gaussian samples errs by sigma^2 = 2/n sum_k R_k^2, R_k = (F^k X)_ii.
    Eigen::Matrix4d lagged = expected.covariance;
    Eigen::Vector4d sum = lagged.diagonal().cwiseAbs2();
    for (int k = 1; k < 500; ++k) {
        lagged = sampled.transition * lagged;
        sum += 2.0 * lagged.diagonal().cwiseAbs2();
    }
    for (int i = 0; i < 4; ++i) {
        const double sigma = std::sqrt(2.0 * sum(i) / kSteps);
        EXPECT_NEAR(squares(i) / kSteps, expected.covariance(i, i), 3.0 * sigma) << i;
        EXPECT_LT(sigma, 0.01 * expected.covariance(i, i)) << i;  // a band of 3 %: the comparison means something
    }
}

spring::SpringLawPtr law_to_2_4() {
    return *spring::make_stiction_law({.k = 0.225, .u = 0.0012, .c = 0.265, .mu = 0.28, .start_torque = 0.6, .end_torque = 2.4});
}

Joint joint_without_friction() {
    Actuator rig;
    rig.law = law_to_2_4();
    rig.capstan_radius = 0.03;
    rig.joint_radius = 0.045;
    rig.least_torque = rig.peak_torque = rig.overdrive_torque = 1.0;
    return joint_of(rig, false);
}

TEST(JointNoise, FallsWithCocontraction) {
    const Joint joint = joint_without_friction();
    const NoiseOptions options{.motor_inertia = 2e-3,
                               .joint_inertia = 5e-3,
                               .motor_viscous = 0.02,
                               .joint_viscous = 0.01,
                               .motor_noise = 1e-5,
                               .joint_noise = 1e-5};
    Eigen::Vector3d earlier = Eigen::Vector3d::Constant(1e9);
    for (double tau = 0.7; tau <= 2.3; tau += 0.2) {
        const auto noise = joint_noise(joint, tau, options);
        ASSERT_TRUE(noise) << core::to_line(noise.refusal().front());
        EXPECT_TRUE((noise->array() < earlier.array()).all()) << tau;
        EXPECT_NEAR((*noise)(kAgonist), (*noise)(kAntagonist), 1e-9 * (*noise)(kAgonist));
        earlier = *noise;
    }
}

// At one temperature the output's variance is T over the stiffness that free capstans leave, 2 g^2 S P/(S + P).
TEST(JointNoise, AtOneTemperatureIsTheFreeCompliance) {
    const Joint joint = joint_without_friction();
    const double temperature = 1e-4, motor = 0.02, output = 0.005, g = 1.5;
    const NoiseOptions options{.motor_inertia = 2e-3,
                               .joint_inertia = 5e-3,
                               .motor_viscous = motor,
                               .joint_viscous = output,
                               .motor_noise = 2.0 * temperature * motor,
                               .joint_noise = 2.0 * temperature * output};
    for (const double tau : {0.8, 1.4, 2.0}) {
        const spring::LawPoint at = law_to_2_4()->at_load(tau);
        const double s = at.s, p = at.p, deviation = (*joint_noise(joint, tau, options))(kOutput);
        EXPECT_NEAR(deviation * deviation, temperature * (s + p) / (2.0 * g * g * s * p), 1e-10 * deviation * deviation);
    }
}

TEST(NoiseRefusal, JointsThatDoNotRestAreRefused) {
    const NoiseOptions options{.motor_inertia = 2e-3, .joint_inertia = 5e-3, .motor_viscous = 0.02, .joint_viscous = 0.01};
    const auto beyond = joint_noise(joint_without_friction(), 5.0, options);  // the law ends at 2.4 Nm
    ASSERT_FALSE(beyond);
    EXPECT_EQ(beyond.refusal().front().rule, "equilibrium.outside");
    Joint floating = joint_without_friction();
    std::erase_if(floating.springs, [](const JointSpring& spring) { return spring.jacobian_row(kOutput) == 0.0; });  // no K_PE: a = b = 0
    const auto free = joint_noise(floating, 0.3, options);
    ASSERT_FALSE(free);
    EXPECT_EQ(free.refusal().front().rule, "equilibrium.free");
    NoiseOptions undamped = options;
    undamped.motor_viscous = undamped.joint_viscous = 0.0;
    const auto ringing = joint_noise(joint_without_friction(), 1.0, undamped);
    ASSERT_FALSE(ringing);
    EXPECT_EQ(ringing.refusal().front().rule, "noise.unbounded");
}

TEST(NoiseRefusal, BadInputIsNamed) {
    const auto field = [](const auto& call) {
        try {
            call();
        } catch (const core::InvalidInput& error) {
            return error.field();
        }
        return std::string("accepted");
    };
    const MatrixXd one = MatrixXd::Identity(2, 2), none = MatrixXd::Zero(2, 2), negative = -one;
    EXPECT_EQ(field([&] { (void)stationary_covariance(none, one, one, one); }), "mass");
    EXPECT_EQ(field([&] { (void)stationary_covariance(MatrixXd(), one, one, one); }), "mass");
    EXPECT_EQ(field([&] { (void)stationary_covariance(one, negative, one, one); }), "damping");
    MatrixXd skewed = one;
    skewed(0, 1) = 0.5;
    EXPECT_EQ(field([&] { (void)stationary_covariance(one, one, skewed, one); }), "stiffness");
    EXPECT_EQ(field([&] { (void)stationary_covariance(one, one, one, MatrixXd::Constant(2, 2, std::nan(""))); }), "density");
    NoisePath path = Random(8).path();
    path.c = -1.0;
    EXPECT_EQ(field([&] { (void)passive_noise(path); }), "c");
    path = Random(8).path();
    path.joint_inertia = 0.0;
    EXPECT_EQ(field([&] { (void)passive_noise(path); }), "joint_inertia");
    EXPECT_EQ(field([&] { (void)joint_noise(joint_without_friction(), 1.0, {}); }), "motor_inertia");
}

}  // namespace
}  // namespace fusee::actuator
