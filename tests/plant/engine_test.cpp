#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#ifdef FUSEE_HAS_MUJOCO
#include "mujoco/engine.h"
#endif
#ifdef FUSEE_HAS_SICONOS
#include "siconos/engine.h"
#endif
#include "fusee/core/error.h"
#include "plant/rigs.h"

// The rig that another engine moves: equilibria, limits and energy that follow from the laws, whatever integrates them.
namespace fusee::plant {
namespace {

using EngineMaker = std::unique_ptr<Engine> (*)();
using NamedEngine = std::pair<const char*, EngineMaker>;

std::vector<NamedEngine> engines() {
    std::vector<NamedEngine> found;
#ifdef FUSEE_HAS_MUJOCO
    found.emplace_back("mujoco", []() -> std::unique_ptr<Engine> { return std::make_unique<MujocoEngine>(Softness{}); });
#endif
#ifdef FUSEE_HAS_SICONOS
    found.emplace_back("siconos", []() -> std::unique_ptr<Engine> { return std::make_unique<SiconosEngine>(); });
#endif
    return found;
}

TEST(EngineRig, EveryEngineIsTested) {
    if (engines().size() < 2) GTEST_SKIP() << "NOT TESTED: rigs of MuJoCo or of Siconos, libmujoco-dev or libsiconos-kernel-dev is missing";
    EXPECT_EQ(engines().size(), 2U);
}

class AnyEngine : public testing::TestWithParam<NamedEngine> {
protected:
    static constexpr double kSe = 0.5, kPe = 0.3;  // [Nm/rad]
    AnyEngine() : nominal_(rigs::straight(kSe, kPe)), truth_(rigs::as_drawn(nominal_)) {}
    [[nodiscard]] std::unique_ptr<Motion> start() const { return GetParam().second()->start(truth_, BuiltSprings(nominal_, truth_), 0.0); }
    /// Smoothly, then a rest.
    static void ramp(Motion& rig, double from, double to) {
        rig.run(4.0, [&](double t) {
            const double s = std::min(1.0, t / 3.5), motor = from + (to - from) * s * s * (3.0 - 2.0 * s);
            return Command{{motor, motor}, 0.0, 0.0};
        });
    }
    Nominal nominal_;
    Truth truth_;
};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(AnyEngine);
INSTANTIATE_TEST_SUITE_P(Rigs, AnyEngine, testing::ValuesIn(engines()), [](const auto& engine) { return std::string(engine.param.first); });

// Law: as for the own machine (machine_test.cpp): load (1 + mu) = torque after winding in; it stays until load (1 - mu) exceeds the torque.
TEST_P(AnyEngine, ACapstanStaysBetweenItsBreakAwayLoads) {
    const std::unique_ptr<Motion> rig = start();
    const auto load = [&] { return (kSe + kPe) * rig->theta(0); };
    ramp(*rig, 0.0, 1.0);
    EXPECT_NEAR(load() * (1.0 + nominal_.mu), 1.0, 0.01);
    const double held = 1.0 / (1.0 + nominal_.mu), low = 1.05 * held * (1.0 - nominal_.mu);
    ramp(*rig, 1.0, low);
    EXPECT_NEAR(load(), held, 0.01);
    ramp(*rig, low, 0.3);
    EXPECT_NEAR(load(), 0.3 / (1.0 - nominal_.mu), 0.01);
    EXPECT_NEAR(rig->q(), 0.0, 1e-6);
}

// Law: with gears that hold both capstans, the joint rests where g^2 k (q1 + q2) = torque, a weight and a hand that damps included.
TEST_P(AnyEngine, TheJointRestsWhereItsTorquesBalance) {
    truth_.joint.gravity = 0.15;
    const std::unique_ptr<Motion> rig = start();
    ramp(*rig, 0.0, 1.0);
    rig->run(3.0, [](double t) { return Command{{1.0, 1.0}, 0.2 * std::min(1.0, t), 0.2}; });
    const double g = nominal_.ratio(), q = rig->q();
    const double cables = g * kSe * ((rig->theta(0) + g * q) - (rig->theta(1) - g * q));
    EXPECT_NEAR(cables + truth_.joint.gravity * std::sin(q), 0.2, 2e-3);
}

TEST_P(AnyEngine, StopsHold) {
    truth_.joint.stop = 0.3;
    const std::unique_ptr<Motion> rig = start();
    rig->run(3.0, [](double t) { return Command{{0.0, 0.0}, std::min(t, 1.0), 0.3}; });
    EXPECT_NEAR(rig->q(), 0.3, 0.01);
    EXPECT_GT(rig->theta(0), -5e-3);  // unwound
}

// Law: pushed to one side and to the other, the link turns by its play and by 2 T/(2 g^2 k) of the cables, whose capstans stick.
TEST_P(AnyEngine, ALinkWithPlayTurnsBeforeItsPulleyDoes) {
    truth_.joint.play = 0.06;
    const std::unique_ptr<Motion> rig = start();
    ramp(*rig, 0.0, 1.0);
    ramp(*rig, 1.0, 0.9);  // inside both limits of the gears
    const auto pushed = [&](double torque) {
        rig->run(3.0, [&](double t) { return Command{{0.9, 0.9}, torque * std::min(1.0, t), 0.1}; });
        return rig->q();
    };
    const double g = nominal_.ratio(), push = 0.02;
    EXPECT_NEAR(pushed(push) - pushed(-push), 0.06 + push / (g * g * kSe), 2e-3);
    EXPECT_THROW((void)Engine().start(truth_, BuiltSprings(nominal_, truth_), 0.0), core::InvalidInput);
}

// Law: a spring with hysteresis a holds the joint between F (1 - a) and F (1 + a); its friction acts on both sides of the cable.
TEST_P(AnyEngine, HysteresisIsAFrictionAlongTheCable) {
    for (SideTruth& side : truth_.sides) side.mu = 0.0, side.se.hysteresis = 0.2;
    const std::unique_ptr<Motion> rig = start();
    ramp(*rig, 0.0, 1.0);
    const double wound = rig->theta(0);
    EXPECT_NEAR(wound * (kSe * 1.2 + kPe), 1.0, 0.01);
    ramp(*rig, 1.0, 0.9);
    EXPECT_NEAR(rig->theta(0), wound, 2e-3) << "held: 0.9 Nm is within the loop";
    ramp(*rig, 0.9, 0.3);
    EXPECT_NEAR(rig->theta(0) * (kSe * 0.8 + kPe), 0.3, 0.01);
}

#ifdef FUSEE_HAS_MUJOCO
// Law: a load (tau + c)/(1 - mu) drives a gear back, and under (tau - c)/(1 + mu) its motor lifts it; 0.3 mNm until it is seen to turn.
TEST(MujocoRig, ALoadThatRisesDrivesTheGearBack) {
    SideTruth side = rigs::as_drawn(rigs::straight(0.5, 0.3)).sides[0];
    side.coulomb = 0.03;
    const MujocoEngine engine({});
    for (const double motor : {0.2, 1.0}) {
        EXPECT_NEAR(engine.break_away(side, motor, true, 1.0, 1.0, 0.0), (motor + 0.03) / (1.0 - side.mu), 5e-4);
        EXPECT_NEAR(engine.break_away(side, motor, false, 1.0, 1.0, 0.0), (motor - 0.03) / (1.0 + side.mu), 5e-4);
    }
}
#endif

// Law: a capstan that sticks creeps in MuJoCo, whose friction is soft, at v = (1 - d) f T/(2 I) and no faster; in Siconos not at all.
TEST_P(AnyEngine, AStickingCapstanCreepsAsItsEngineSays) {
    const std::unique_ptr<Motion> rig = start();
    ramp(*rig, 0.0, 1.0);
    const double torque = 0.7, friction = (kSe + kPe) * rig->theta(0) - torque;
    ramp(*rig, 1.0, torque);
    const double before = rig->theta(0);
    rig->run(4.0, [&](double) { return Command{{torque, torque}, 0.0, 0.0}; });
    double creep = 0.0;
#ifdef FUSEE_HAS_MUJOCO
    const Softness soft;
    if (GetParam().first == std::string("mujoco")) creep = soft.give * friction * soft.grip_time / (2.0 * truth_.sides[0].inertia);
#endif
    EXPECT_GT(friction, 0.05);
    EXPECT_NEAR(before - rig->theta(0), 4.0 * creep, 0.15 * 4.0 * creep + 1e-9);
}

}  // namespace
}  // namespace fusee::plant
