#include <gtest/gtest.h>

#include "fusee/joint_model/motion.h"
#include "fusee/joint_model/signals.h"
#include "joint_model/fixture.h"

namespace fusee::joint_model {
namespace {

using namespace fixtures;

/// Both capstans at a torque, for long enough to rest.
Motion held(const BuiltRig& rig, double torque, double seconds = 3.0) {
    Motion motion(rig, 1e-3);
    motion.lead_to({torque, torque, 0.0}, 20.0);
    motion.hold(seconds);
    return motion;
}
BuiltRig without_friction(const std::function<void(BuiltRig&)>& change) {
    return built(straight_rig(), [&](BuiltRig& rig) {
        for (BuiltSide& side : rig.sides) {
            side.gear.load_friction = 0.0;
            side.gear.viscous = 0.02;
        }
        change(rig);
    });
}
double agonist_at_rest(const BuiltRig& rig, double torque) { return held(rig, torque, 20.0).theta(gap_case::Side::kAgonist); }

TEST(GenericTerms, ARippleOfTheMotorTorqueIsInTheBalanceOfACapstanAtRest) {
    const Ripple ripple{0.1, 3.0, 0.4};
    BuiltRig rig = without_friction([&](BuiltRig& r) { r.sides[0].gear.terms.torque = ripple; });
    rig.joint_coulomb = 10.0;  // the joint is held
    const double theta = agonist_at_rest(rig, 0.8);
    EXPECT_NEAR((kSeries + kParallel) * theta, 0.8 + ripple(theta), 1e-4);
}

TEST(GenericTerms, CrosstalkAddsAShareOfTheOtherCommand) {
    BuiltRig rig = without_friction([](BuiltRig& r) { r.sides[0].gear.terms.crosstalk = 0.2; });
    rig.joint_coulomb = 10.0;  // the joint is held
    EXPECT_NEAR((kSeries + kParallel) * agonist_at_rest(rig, 0.5), 0.6, 1e-4);
}

TEST(GenericTerms, RippledFrictionStopsACapstanWhereItIsHigh) {
    BuiltRig rig = built(straight_rig(), [](BuiltRig& r) { r.sides[0].gear.terms.friction = {-0.5, 0.0, 1.5707963267948966}; });
    rig.joint_coulomb = 10.0;
    // A ripple of 0 turns at its crest: half of the friction. Wound in slowly: tau = L (1 + mu/2).
    EXPECT_NEAR((kSeries + kParallel) * held(rig, 0.9, 0.0).theta(gap_case::Side::kAgonist), 0.9 / 1.125, 0.01);
}

TEST(GenericTerms, FrictionDriftsFromOneBreakAwayToTheNext) {
    const double d = -0.5, time = 30.0, torque = 0.8, mu = straight_rig().gear_load_friction;
    const BuiltRig rig = built(straight_rig(), [&](BuiltRig& r) { r.sides[0].gear.terms.friction_drift = {d, time}; });
    gap_case::Rows rows;
    rows.breakaway.assign(20, {"agonist", true, torque, 0.0});
    const std::vector<double> loads = predict_experiment(rig, rows, {}, gap_case::Experiment::kBreakAway);
    for (std::size_t i = 0; i < loads.size(); ++i)  // 3 s each: tau = L (1 - mu)
        EXPECT_NEAR(loads[i], torque / (1.0 - mu * (1.0 + d * (1.0 - std::exp(-3.0 * static_cast<double>(i) / time)))), 1e-12);
}

TEST(GenericTerms, ADeadBandLongAfterTheDriftHasTheFrictionAtItsEnd) {
    gap_case::Rows rows;
    rows.breakaway.assign(200, {"agonist", true, 0.8, 0.0});
    for (const double torque : {0.6, 1.0}) rows.dead_band.push_back({torque, 1, 1.2, 0.0, 0.0});
    const auto of = [&](const std::function<void(BuiltRig&)>& change) {
        return predict_experiment(built(stiffening_rig(), change), rows, {}, gap_case::Experiment::kDeadBand);
    };
    const std::vector<double> drifted = of([](BuiltRig& r) { r.sides[1].gear.terms.friction_drift = {-0.4, 10.0}; });
    const std::vector<double> less = of([](BuiltRig&r) { r.sides[1].gear.load_friction *= 0.6; }), as_built = of([](BuiltRig&) {});
    for (std::size_t i = 0; i < drifted.size(); ++i) EXPECT_NEAR(drifted[i], less[i], 1e-6) << i;
    EXPECT_GT(std::abs(drifted[1] - as_built[1]), 0.01);
}

TEST(GenericTerms, RepeatsThatAreComputedOnceKeepTheTimeOfTheSession) {
    gap_case::Rows all, once;
    for (std::size_t i = 0; i < 6; ++i) all.dead_band.push_back({i < 3 ? 0.6 : 1.0, 1, 1.2, 0.0, 0.0});
    once.dead_band = {all.dead_band[2], all.dead_band[5]};
    once.dead_band[0].row = 3;
    once.dead_band[1].row = 6;
    all.cocontraction = once.cocontraction = {{true, 0.5, 0.0, 0.0, 0.0}, {true, 1.0, 0.0, 0.0, 0.0}};
    const BuiltRig rig = built(stiffening_rig(), [](BuiltRig& r) { r.sides[0].gear.terms.friction_drift = {-0.4, 60.0}; });
    const auto experiment = gap_case::Experiment::kCocontraction;
    EXPECT_EQ(predict_experiment(rig, all, {}, experiment), predict_experiment(rig, once, {}, experiment));
    once.dead_band[1].row = 0;
    EXPECT_NE(predict_experiment(rig, all, {}, experiment), predict_experiment(rig, once, {}, experiment));
}

// Long after each drift: the torque of motor and springs is (1 + d) times.
TEST(GenericTerms, MotorAndSpringsDriftToTheirEnd) {
    const auto theta = [](const std::function<void(BuiltRig&)>& change) {
        BuiltRig rig = without_friction(change);
        rig.joint_coulomb = 10.0;  // the joint is held
        Motion motion(rig, 1e-3, 1e6);
        motion.lead_to({0.5, 0.5, 0.0}, 20.0);
        motion.hold(20.0);
        return motion.theta(gap_case::Side::kAgonist);
    };
    EXPECT_NEAR((kSeries + kParallel) * theta([](BuiltRig& r) { r.sides[0].gear.terms.torque_drift = {-0.2, 50.0}; }), 0.4, 1e-4);
    EXPECT_NEAR((0.7 * kSeries + kParallel) * theta([](BuiltRig& r) { r.sides[0].se_terms.drift = {-0.3, 50.0}; }), 0.5, 1e-4);
    EXPECT_NEAR((kSeries + 1.4 * kParallel) * theta([](BuiltRig& r) { r.sides[0].pe_terms.drift = {0.4, 50.0}; }), 0.5, 1e-4);
}

TEST(GenericTerms, EachTestOfAPartHasTheDriftOfItsTime) {
    const double d = -0.2, time = 20.0, torque = 0.8, mu = straight_rig().gear_load_friction;
    gap_case::Rows rows;
    rows.breakaway.assign(10, {"agonist", true, torque, 0.0});
    for (int i = 0; i < 8; ++i) rows.spring_pull.push_back({true, gap_case::Side::kAgonist, true, 0.5, 0.0});
    const BuiltRig rig = built(straight_rig(), [&](BuiltRig& r) {
        r.sides[0].gear.terms.torque_drift = {d, time};
        r.sides[0].se_terms.drift = {d, time};
    });
    const std::vector<double> loads = predict_experiment(rig, rows, {}, gap_case::Experiment::kBreakAway),
                              pulls = predict_experiment(rig, rows, {}, gap_case::Experiment::kSpringPull);
    const auto factor = [&](double session) { return 1.0 + d * (1.0 - std::exp(-session / time)); };
    for (std::size_t i = 0; i < loads.size(); ++i)  // 3 s each
        EXPECT_NEAR(loads[i], torque * factor(3.0 * static_cast<double>(i)) / (1.0 - mu), 1e-12);
    for (std::size_t i = 0; i < pulls.size(); ++i)  // after the 30 s, 10 s for the 8 rows
        EXPECT_NEAR(pulls[i], 0.5 * kSeries * factor(30.0 + 1.25 * static_cast<double>(i)), 1e-9);
}

TEST(GenericTerms, TheJointsEncoderDriftsBetweenTheTwoReadingsOfADeadBand) {
    gap_case::Rows rows;
    rows.dead_band.push_back({1.0, 1, 1.2, 0.0, 0.0});
    const auto read = [&](joint_model::Drift zero) {
        return predict_experiment(built(stiffening_rig(), [&](BuiltRig& r) { r.terms.zero = zero; }), rows, {},
                                  gap_case::Experiment::kDeadBand);
    };
    const std::vector<double> still = read({}), drifted = read({0.1, 4.0});
    const auto shift = [](double session) { return 0.1 * (1.0 - std::exp(-session / 4.0)); };
    EXPECT_NEAR(drifted[1] - still[1], shift(5.75), 1e-9);  // q_high: 1 s of ramp, 4.75 s of push and release
    EXPECT_NEAR(drifted[0] - still[0], shift(10.5), 1e-9);  // q_low
    rows.dead_band_width_only = true;
    EXPECT_NEAR(read({0.1, 4.0})[0] - read({})[0], shift(5.75) - shift(10.5), 1e-9);
}

TEST(GenericTerms, ADragOfPowerOneIsTheViscousDrag) {
    gap_case::Rows rows;
    for (int i = 0; i < 100; ++i) rows.log.push_back({0.02 * i, 0.5, 0.5, 0.4 * std::sin(0.2 * i), 0.0, 0.0, 0.0});
    const auto read = [&](const std::function<void(BuiltRig&)>& change) {
        return predict_experiment(built(straight_rig(), change), rows, {}, gap_case::Experiment::kLog);
    };
    const std::vector<double> drag = read([](BuiltRig&r) { r.terms.drag = 0.05, r.terms.drag_power = 1.0; }),
                              viscous = read([](BuiltRig&r) { r.joint_viscous += 0.05; }),
                              fluid = read([](BuiltRig&r) { r.terms.drag = 0.05; });
    EXPECT_LT(farthest(drag, viscous), 1e-9);
    EXPECT_GT(farthest(fluid, viscous), 1e-3);
}

TEST(GenericTerms, TheSpringToGroundAndTheRippleActAtTheJoint) {
    BuiltRig rig = without_friction([](BuiltRig& r) {
        r.terms.spring = 0.5;
        r.terms.hardening = 2.0;
    });
    Motion motion(rig, 1e-3);
    motion.hand_damping = 0.5;
    motion.lead_to({0.0, 0.0, 0.3}, 1.0);
    motion.hold(20.0);
    const double q = motion.q(), g = rig.mean_ratio(), slack = g * kSeries * g * std::abs(q);  // one cable, its capstan at its stop
    EXPECT_NEAR(0.5 * q + 2.0 * q * q * q + slack, 0.3, 2e-3);
    EXPECT_GT(q, 0.0);
}

TEST(GenericTerms, ASlopeScalesTheTableOfASpring) {
    const SpringTerms terms{.slope = 0.3, .drift = {}};
    const BuiltRig plain = faultless(stiffening_rig()), changed = built(stiffening_rig(), [&](BuiltRig&r) { r.sides[1].pe_terms = terms; });
    const double end = plain.sides[1].pe.end();
    for (const double share : {0.1, 0.3, 0.45, 0.6, 0.9}) {
        EXPECT_NEAR(changed.sides[1].pe.torque(share * end) / plain.sides[1].pe.torque(share * end), 1.0 + 0.3 * share, 1e-6) << share;
    }
}

TEST(GenericTerms, ASpringThatIsHeldLosesItsShareWithItsTimeConstant) {
    const double a = 0.4, time = 0.5;
    BuiltRig rig = without_friction([&](BuiltRig& r) {
        r.sides[0].pe_terms.relaxation = a;
        r.sides[0].pe_terms.relaxation_time = time;
    });
    rig.joint_coulomb = 10.0;
    EXPECT_NEAR(agonist_at_rest(rig, 0.8), 0.8 / (kSeries + (1.0 - a) * kParallel), 1e-3);  // long after
    gap_case::Rows rows;  // up in 5 s as the protocol's phase, then held for 5 s
    for (int i = 0; i < 200; ++i)
        rows.spring_pull.push_back({false, gap_case::Side::kAgonist, i < 100, 2.0 * std::min(1.0, i / 100.0), 0.0});
    const double last = predict_experiment(rig, rows, {}, gap_case::Experiment::kSpringPull).back();
    EXPECT_NEAR(last / (2.0 * kParallel), 1.0 - a, 1e-3);
}

TEST(GenericTerms, ACableSlipsUntilItsTorqueIsAtTheLimit) {
    BuiltRig rig = without_friction([](BuiltRig& r) {
        r.sides[0].se_terms.slip_at = 0.25;
        r.sides[0].se_terms.slip_drag = 0.1;
    });
    rig.joint_coulomb = 10.0;
    EXPECT_NEAR(agonist_at_rest(rig, 0.8), (0.8 - 0.25) / kParallel, 0.02);  // K_PE bears the rest
}

TEST(GenericTerms, ReadingsOfTheEncodersAreThoseOfTheirLaws) {
    gap_case::Rows rows;
    for (int i = 0; i <= 40; ++i) rows.log.push_back({0.05 * i, 0.6 + 0.2 * std::sin(0.3 * i), 0.6 - 0.2 * std::sin(0.3 * i), 0.1, {}, {}});
    const auto log = [&](const std::function<void(BuiltRig&)>& change) {
        return predict_experiment(without_friction(change), rows, {}, gap_case::Experiment::kLog);
    };
    const std::vector<double> plain = log([](BuiltRig&) {});
    const Ripple ripple{0.05, 1.0, 0.2};
    const std::vector<double> rippled = log([&](BuiltRig& r) { r.sides[1].gear.terms.reading = ripple; });
    const std::vector<double> scaled = log([](BuiltRig& r) { r.terms.reading = 0.1; });
    const std::vector<double> soft = log([](BuiltRig& r) { r.terms.flexibility = 0.2; });
    const std::vector<double> late = log([](BuiltRig& r) { r.terms.lag = 0.1; });
    for (std::size_t i = 0; i < plain.size(); i += 3) {
        EXPECT_NEAR(rippled[i + 1], plain[i + 1] + ripple(plain[i + 1]), 1e-12);
        EXPECT_NEAR(scaled[i + 2], 1.1 * plain[i + 2], 1e-12);
        EXPECT_NEAR(soft[i + 2], plain[i + 2] + 0.02, 1e-12);
        EXPECT_NEAR(late[i + 2], plain[i < 6 ? 2 : i + 2 - 6], 1e-12);
    }
}

// The pulley is held: only the link turns.
TEST(GenericTerms, ALinkWithPlayFliesFromOneEndOfItToTheOther) {
    const double play = 0.06, torque = 0.02, seconds = 0.05;
    const BuiltRig rig = built(straight_rig(), [&](BuiltRig& r) {
        r.joint_coulomb = 10.0;
        r.terms.play = play;
    });
    Motion motion(rig, 1e-5);
    motion.lead_to({0.0, 0.0, torque}, seconds);
    EXPECT_NEAR(motion.q(), torque * seconds * seconds / (6.0 * 0.9 * rig.joint_inertia), 1e-5);
    motion.hold(1.0);
    EXPECT_NEAR(motion.q(), 0.5 * play, 1e-4);
    motion.lead_to({}, 0.1);
    motion.hold(1.0);
    EXPECT_NEAR(motion.q(), 0.5 * play, 1e-4);
    motion.lead_to({0.0, 0.0, -torque}, 1.0);
    EXPECT_NEAR(motion.q(), -0.5 * play, 1e-4);
}

TEST(GenericTerms, ALinkWithPlayMovesAsOneWithItsPulleyWhileTheyTouch) {
    const auto swing = [](double play) {
        const BuiltRig rig = without_friction([&](BuiltRig& r) { r.terms.play = play; });
        Motion motion(rig, 1e-4);
        motion.lead_to({0.6, 0.6, 0.05}, 2.0);
        motion.lead_to({0.6, 0.6, 0.4}, 2.0);
        return motion.q();
    };
    EXPECT_NEAR(swing(0.06), swing(0.0) + 0.03, 1e-3);
}

TEST(GenericTerms, ADeadBandIsWiderByThePlayOfTheLink) {
    gap_case::Rows rows;
    for (const double torque : {0.6, 1.0}) rows.dead_band.push_back({torque, 1, 1.2, 0.0, 0.0});
    const auto of = [&](double play) {
        return predict_experiment(built(stiffening_rig(), [&](BuiltRig& r) { r.terms.play = play; }), rows, {},
                                  gap_case::Experiment::kDeadBand);
    };
    const std::vector<double> tight = of(0.0), loose = of(0.06);
    for (std::size_t i = 0; i < tight.size(); ++i) EXPECT_NEAR(loose[i] - tight[i], i % 2 == 0 ? -0.03 : 0.03, 0.01) << i;
}

TEST(GenericTerms, AnEccentricPulleyKeepsTheEnergy) {
    // What the arm winds is the integral of its factor.
    const Ripple arm{0.2, 1.0, 0.7};
    double sum = 0.0;
    for (int i = 0; i < 1000; ++i) sum += arm((i + 0.5) * 1e-3) * 1e-3;
    EXPECT_NEAR(arm.integral(1.0), sum, 1e-7);
}

}  // namespace
}  // namespace fusee::joint_model
