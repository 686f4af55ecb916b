#include "fusee/joint_model/motion.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>

#include "fusee/actuator/stick_slip.h"
#include "fusee/core/units.h"
#include "joint_model/fixture.h"

// Laws and closed forms of a rig with straight springs. `Motion` is of first order in its step: the tolerances of what moves are a few
// steps times the greatest speed.
namespace fusee::joint_model {
namespace {

using namespace fixtures;

constexpr double kFine = 1e-4;                       // [s]
constexpr double kBoth = 2.0 * 2.0 * 2.0 * kSeries;  // g^2 2 k_SE: the joint's stiffness while both capstans rest [Nm/rad]

/// No friction, no drag.
BuiltRig free_rig() {
    return built(straight_rig(), [](BuiltRig& rig) {
        for (BuiltSide& side : rig.sides) side.gear = {};
        rig.joint_viscous = 0.0;
    });
}
/// Gears that hold their capstans as soon as the motors' torque falls a little.
BuiltRig held_rig(double joint_viscous = 0.0) {
    return built(straight_rig(), [&](BuiltRig& rig) {
        for (BuiltSide& side : rig.sides) side.gear.load_friction = 0.9;
        rig.joint_viscous = joint_viscous;
    });
}
/// Co-contracted, and both capstans well inside what their gears hold.
Motion held(const BuiltRig& rig, double step = kFine) {
    Motion motion(rig, step);
    motion.lead_to({1.5, 1.5, 0.0}, 1.0);
    motion.lead_to({1.0, 1.0, 0.0}, 0.2);
    return motion;
}

/// Springs, motors and bodies, speeds from the last step. Both cables taut.
class Energy {
public:
    Energy(const BuiltRig& rig, Motion& motion) : rig_(rig), motion_(motion) {}
    double after(double seconds, double motor_torque) {
        motion_.hold(seconds - kFine);
        const double t1 = motion_.theta(gap_case::Side::kAgonist), t2 = motion_.theta(gap_case::Side::kAntagonist), q = motion_.q();
        motion_.hold(kFine);
        const double n1 = motion_.theta(gap_case::Side::kAgonist), n2 = motion_.theta(gap_case::Side::kAntagonist), nq = motion_.q();
        const double moving = 0.5 * rig_.sides[0].motor_inertia * (square((n1 - t1) / kFine) + square((n2 - t2) / kFine)) +
                              0.5 * rig_.joint_inertia * square((nq - q) / kFine);
        const double g = rig_.mean_ratio();
        return moving + 0.5 * kSeries * (square(n1 + g * nq) + square(n2 - g * nq)) + 0.5 * kParallel * (square(n1) + square(n2)) -
               motor_torque * (n1 + n2);
    }

private:
    static double square(double x) { return x * x; }
    const BuiltRig& rig_;
    Motion& motion_;
};

TEST(Motion, AnEncoderBehindBacklashKeepsTheFarthestThatItsCapstanCame) {
    BuiltRig rig = free_rig();
    rig.sides[0].gear.backlash = 0.05;
    Motion motion(rig, kFine), step_by_step(rig, kFine);
    motion.lead_to({1.0, 1.0, 0.0}, 200 * kFine);  // a quick pull overshoots
    double most = 0.0;
    for (int i = 1; i <= 200; ++i) {
        step_by_step.lead_to({i / 200.0, i / 200.0, 0.0}, kFine);
        most = std::max(most, step_by_step.theta(gap_case::Side::kAgonist));
    }
    for (int i = 0; i < 4000; ++i) {
        motion.hold(2 * kFine);
        step_by_step.hold(kFine);
        most = std::max(most, step_by_step.theta(gap_case::Side::kAgonist));
        step_by_step.hold(kFine);
        most = std::max(most, step_by_step.theta(gap_case::Side::kAgonist));
        const double theta = motion.theta(gap_case::Side::kAgonist), encoder = motion.encoder(gap_case::Side::kAgonist);
        ASSERT_NEAR(encoder, step_by_step.encoder(gap_case::Side::kAgonist), 1e-9) << i;
        ASSERT_LE(std::abs(encoder - theta), 0.025 + 1e-12);
    }
    EXPECT_GT(most - motion.theta(gap_case::Side::kAgonist), 0.01) << "no overshoot: the test shows nothing";
    EXPECT_EQ(motion.encoder(gap_case::Side::kAntagonist), motion.theta(gap_case::Side::kAntagonist));
}

TEST(Motion, EnergyStaysWithoutFrictionAndFallsWithAny) {
    const auto with = [](double mu, double coulomb, double viscous) {
        BuiltRig rig = free_rig();
        for (BuiltSide& side : rig.sides) side.gear.load_friction = mu;
        rig.joint_coulomb = coulomb;
        rig.joint_viscous = viscous;
        return rig;
    };
    constexpr double kTorque = 1.0;
    for (const BuiltRig& rig : {with(0, 0, 0), with(0.05, 0, 0), with(0, 0.02, 0), with(0, 0, 0.005)}) {
        Motion motion(rig, kFine);
        motion.lead_to({kTorque, kTorque, 0.4}, 0.3);
        motion.lead_to({kTorque, kTorque, 0.0}, 0.0);
        Energy energy(rig, motion);
        const double first = energy.after(0.01, kTorque), scale = 0.05;  // [J], of the swings
        double last = first;
        for (int i = 0; i < 40; ++i) {
            const double now = energy.after(0.05, kTorque);
            EXPECT_LT(now, last + 0.01 * scale);  // the energy of symplectic Euler swings by omega h/2 of itself: 0.3 %
            last = now;
        }
        const bool free = rig.joint_viscous == 0.0 && rig.joint_coulomb == 0.0 && rig.sides[0].gear.load_friction == 0.0;
        EXPECT_GT(last, free ? first - 0.01 * scale : -1e9);
        EXPECT_LT(last, free ? first + 0.01 * scale : first - 0.2 * scale);
    }
}

TEST(Motion, StaysExactlyWhereItIsBelowTheLimit) {
    BuiltRig rig = held_rig();
    rig.joint_coulomb = 0.05;
    Motion motion = held(rig);
    motion.hold(2.0);
    const double theta = motion.theta(gap_case::Side::kAgonist), q = motion.q();
    EXPECT_EQ(motion.theta(gap_case::Side::kAntagonist), theta);  // both sides the same, to the last bit
    for (const double joint : {0.049, -0.049, 0.0}) {
        motion.lead_to({1.2, 0.9, joint}, 0.5);
        motion.hold(5.0);
        EXPECT_EQ(motion.theta(gap_case::Side::kAgonist), theta);
        EXPECT_EQ(motion.q(), q);
    }
    motion.lead_to({1.2, 0.9, 0.06}, 0.5);
    EXPECT_GT(motion.q(), q);
}

TEST(Motion, WindsInAtTheLoadTauOver1PlusMuAndPaysOutAtTauOver1MinusMu) {
    const gap_case::NominalRig nominal = straight_rig();
    const BuiltRig rig = built(nominal, [](BuiltRig& r) {
        for (BuiltSide& side : r.sides) side.gear.viscous = 0.0;
    });
    const double mu = nominal.gear_load_friction, k = kSeries + kParallel;
    Motion motion(rig, kSlowStep);
    const auto at = [&](double torque) {
        motion.lead_to({torque, torque, 0.0}, 20.0);
        motion.hold(2.0);  // what inertia carries on
        return motion.theta(gap_case::Side::kAgonist);
    };
    // Inertia sets up a swing of speed sqrt(J/k), and as much again where the ramp ends: 13 mrad
    const double speed = 1.0 / k / 20.0, slow = 2.0 * speed * std::sqrt(nominal.motor_inertia / k);
    EXPECT_NEAR(at(1.0), 1.0 / (1.0 + mu) / k, slow);
    const double stuck = motion.theta(gap_case::Side::kAgonist), lets_go = (1.0 - mu) * k * stuck;
    EXPECT_EQ(at(lets_go + 1e-3), stuck);
    EXPECT_LT(at(lets_go - 1e-2), stuck);
    EXPECT_NEAR(at(0.3), 0.3 / (1.0 - mu) / k, slow);
}

/// Times at which q crosses 0 upwards in `seconds`, linearly between two steps.
std::vector<double> crossings(Motion& motion, double seconds) {
    std::vector<double> times;
    double last = motion.q();
    for (int i = 1; i * kFine < seconds; ++i) {
        motion.hold(kFine);
        const double now = motion.q();
        if (last < 0.0 && now >= 0.0) times.push_back(kFine * (i - now / (now - last)));
        last = now;
    }
    return times;
}

TEST(Motion, ALinearJointSwingsWithTheFrequencyAndTheDecayOfItsStiffnessInertiaAndDrag) {
    const double drag = 0.004;
    const BuiltRig rig = held_rig(drag);
    Motion motion = held(rig);
    motion.lead_to({1.0, 1.0, 0.1}, 0.3);
    motion.lead_to({1.0, 1.0, 0.0}, 0.0);
    const double decay = drag / (2.0 * rig.joint_inertia), omega = std::sqrt(kBoth / rig.joint_inertia - decay * decay);
    const std::vector<double> times = crossings(motion, 2.0);
    ASSERT_GE(times.size(), 5U);
    const double period = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
    EXPECT_NEAR(2.0 * core::kPi / period / omega, 1.0, 1e-3);  // (omega h)^2/24 is 2e-7; the crossings are read to 1e-4 s

    double before = 0.0, after = 0.0;
    for (double* most : {&before, &after})
        for (double t = 0.0; t < 2.0 * core::kPi / omega; t += kFine) {
            motion.hold(kFine);
            *most = std::max(*most, std::abs(motion.q()));
        }
    EXPECT_NEAR(std::log(before / after) / (decay * 2.0 * core::kPi / omega), 1.0, 0.01);
}

TEST(Motion, ViscousDragAtACapstanFollowsTheEquationOfSecondOrder) {
    const double drag = 0.2, torque = 0.6, k = kSeries + kParallel;
    BuiltRig rig = free_rig();
    for (BuiltSide& side : rig.sides) side.gear.viscous = drag;
    const double j = rig.sides[0].motor_inertia, root = std::sqrt(drag * drag - 4.0 * j * k);
    const double slow = (-drag + root) / (2.0 * j), fast = (-drag - root) / (2.0 * j);
    Motion motion(rig, kFine);
    motion.lead_to({torque, torque, 0.0}, 0.0);
    for (int i = 1; i <= 20; ++i) {
        motion.hold(0.05);
        const double t = 0.05 * i;
        const double exact = torque / k * (1.0 - (slow * std::exp(fast * t) - fast * std::exp(slow * t)) / (slow - fast));
        EXPECT_NEAR(motion.theta(gap_case::Side::kAntagonist), exact, 5e-4) << t;  // a step at the greatest speed, 3 rad/s
    }
}

TEST(Motion, WeightAndStopStandAgainstTheJointTorque) {
    const auto rest = [](double gravity, double stop, double torque) {
        BuiltRig rig = held_rig(0.1);
        rig.gravity = gravity;
        rig.stop = stop;
        Motion motion = held(rig);
        motion.lead_to({1.0, 1.0, torque}, 0.5);
        motion.hold(3.0);
        return motion.q();
    };
    const double heavy = rest(0.3, kNever, 0.4);
    EXPECT_NEAR(kBoth * heavy + 0.3 * std::sin(heavy), 0.4, 1e-6);
    EXPECT_NEAR(rest(0.3, kNever, -0.4), -heavy, 1e-6);
    const double stiff = BuiltRig(straight_rig()).stop_stiffness;
    EXPECT_NEAR(rest(0.0, 0.05, 0.4), (0.4 + stiff * 0.05) / (kBoth + stiff), 1e-6);
    EXPECT_NEAR(rest(0.0, 0.05, -0.4), -(0.4 + stiff * 0.05) / (kBoth + stiff), 1e-6);
    EXPECT_NEAR(rest(0.0, 1.0, 0.4), 0.4 / kBoth, 1e-6);
}

TEST(Motion, ACapstanPaysOutNoFartherThanItsStop) {
    BuiltRig rig = free_rig();
    rig.joint_viscous = 0.1;
    Motion motion(rig, kFine);
    motion.lead_to({0.0, 0.0, 0.5}, 1.0);
    motion.hold(3.0);
    EXPECT_EQ(motion.theta(gap_case::Side::kAgonist), 0.0);
    EXPECT_EQ(motion.theta(gap_case::Side::kAntagonist), 0.0);
    EXPECT_NEAR(motion.q(), 0.5 / (rig.mean_ratio() * rig.mean_ratio() * kSeries), 1e-6);  // the antagonist's cable hangs loose
}

TEST(Motion, EachSideHasItsOwnRadii) {
    constexpr std::array<double, 2> kRatio{2.1, 1.9}, kScale{1.02, 0.97};
    BuiltRig rig = free_rig();
    rig.joint_viscous = 0.1;
    for (std::size_t i = 0; i < 2; ++i) {
        rig.sides[i].ratio = kRatio[i];
        rig.sides[i].capstan_scale = kScale[i];
        rig.sides[i].gear.viscous = 0.05;
    }
    Motion motion(rig, kFine);
    motion.lead_to({0.6, 0.8, 0.1}, 1.0);
    motion.hold(20.0);
    // At rest s_i F_i + k_PE theta_i = tau_i and g_1 F_1 - g_2 F_2 = tau_q, with F_i = k_SE (s_i theta_i +- g_i q).
    const double s1 = kScale[0], s2 = kScale[1], g1 = kRatio[0], g2 = kRatio[1];
    Eigen::Matrix3d stiffness;
    stiffness << s1 * s1 * kSeries + kParallel, 0.0, s1 * g1 * kSeries,  //
        0.0, s2 * s2 * kSeries + kParallel, -s2 * g2 * kSeries,          //
        s1 * g1 * kSeries, -s2 * g2 * kSeries, (g1 * g1 + g2 * g2) * kSeries;
    const Eigen::Vector3d rest = stiffness.ldlt().solve(Eigen::Vector3d(0.6, 0.8, 0.1));
    EXPECT_NEAR(motion.theta(gap_case::Side::kAgonist), rest[0], 1e-6);
    EXPECT_NEAR(motion.theta(gap_case::Side::kAntagonist), rest[1], 1e-6);
    EXPECT_NEAR(motion.q(), rest[2], 1e-6);
}

/// Where a damped swing of all three bodies is after 0.4 s.
double swung(double step) {
    const BuiltRig rig = faultless(straight_rig());
    Motion motion(rig, step);
    motion.lead_to({0.8, 0.5, 0.2}, 0.1);
    motion.hold(0.3);
    return motion.q();
}

TEST(Motion, HalvingTheStepHalvesTheError) {
    const double exact = swung(1e-5);
    const double coarse = swung(8e-4) - exact, fine = swung(4e-4) - exact;
    EXPECT_GT(std::abs(coarse), 1e-5);
    EXPECT_NEAR(coarse / fine, 2.0, 0.3);
}

TEST(StepOn, FollowsTheTimeOfTheRigWithinItsPhases) {
    const gap_case::Protocol usual;
    EXPECT_EQ(step_on({}, usual, kSlowStep), kSlowStep);
    EXPECT_EQ(step_on({.time = 2.0}, usual, kSlowStep), 2.0 * kSlowStep);
    EXPECT_EQ(step_on({.time = 100.0}, usual, kSlowStep), kStepRange * kSlowStep);
    EXPECT_EQ(step_on({.time = 0.01}, usual, kSlowStep), kSlowStep / kStepRange);
    gap_case::Protocol fast{.motor_ramp = 0.3, .motor_settle = 0.2};  // half as long in all
    fast.dead_band_push = 0.8;
    fast.dead_band_release = 1.575;
    fast.joint_stiffness_phase = 1.0;
    fast.cocontraction_phase = 2.5;
    EXPECT_NEAR(step_on({.time = 0.01}, fast, kSlowStep), 0.5 * kSlowStep / kStepRange, 1e-15);
}

TEST(Motion, LedSlowlyItIsTheQuasiStaticStickSlip) {
    const gap_case::NominalRig nominal = straight_rig();
    const BuiltRig rig = built(nominal, [](BuiltRig& r) {
        r.joint_coulomb = 0.02;
        r.tension_friction = 0.05;
        r.joint_viscous = 0.05;
    });
    const auto law = spring::FrictionLaw::proportional(nominal.gear_load_friction);
    const auto pe = spring::make_polynomial({0.0, kParallel}), se = spring::make_polynomial({0.0, kSeries});
    actuator::Joint joint = actuator::antagonist(pe, se, se, pe, {law, law}, nominal.capstan_radius, nominal.joint_radius);
    joint.output_friction = {0.02, 0.05};
    actuator::StickSlip slow(joint);
    Motion motion(rig, kSlowStep);
    const std::vector<Motion::Torques> path{{1.0, 1.0, 0.0}, {1.0, 1.0, 1.2}, {1.0, 1.0, 0.0}, {1.0, 1.0, -0.7},
                                            {1.0, 1.0, 0.0}, {0.6, 1.2, 0.0}, {0.6, 1.2, 0.3}, {0.4, 0.4, 0.0}};
    for (const Motion::Torques& torques : path) {
        slow.lead_to({torques.agonist, torques.antagonist, torques.joint}, 200);
        motion.lead_to(torques, 80.0);
        motion.hold(2.0);
        // What inertia (speed sqrt(J/K), 0.03 rad/s x 0.06 s) and drag (0.05 Nms/rad x 0.03 rad/s over 1 Nm/rad) add
        EXPECT_NEAR(motion.theta(gap_case::Side::kAgonist), slow.z()[actuator::kAgonist], 5e-3);
        EXPECT_NEAR(motion.theta(gap_case::Side::kAntagonist), slow.z()[actuator::kAntagonist], 5e-3);
        EXPECT_NEAR(motion.q(), slow.z()[actuator::kOutput], 5e-3);
    }
}

}  // namespace
}  // namespace fusee::joint_model
