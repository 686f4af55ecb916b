#include "fusee/plant/machine.h"

#include <gtest/gtest.h>

#include <cmath>

#include "plant/rigs.h"

namespace fusee::plant {
namespace {

/// A motor without springs that drives against its gear alone: load 0, so that its friction is the constant one.
struct Gear {
    Bristles bristles;
    double inertia = 0.002, angle = 0.0, speed = 0.0;
    void push(double torque, double limit, double seconds) {
        for (double t = 0.0; t < seconds; t += Machine::kStep) {
            speed += Machine::kStep / inertia * (torque - bristles.torque());
            angle += Machine::kStep * speed;
            bristles.step(speed, limit, Machine::kStep);
        }
    }
};

TEST(Bristles, StickBelowTheLimitAndSlideAboveIt) {
    for (const Presliding kind : {Presliding::kElastoPlastic, Presliding::kLuGre}) {
        Gear gear{Bristles(kind, 1500.0, 2.0)};
        gear.push(0.095, 0.1, 1.0);
        EXPECT_LT(gear.angle, 0.002);  // bristles bend by 6e-5 rad; LuGre's also creep while the motor swings in
        const double settled = gear.angle;
        gear.push(0.095, 0.1, 2.0);
        EXPECT_NEAR(gear.angle, settled, 1e-6);
        gear.push(0.105, 0.1, 1.0);
        EXPECT_NEAR(gear.speed, 0.005 / 0.002, 0.05);  // what is above the limit accelerates
        EXPECT_NEAR(gear.bristles.torque(), 0.1, 1e-6);
    }
}

// Known (Dupont et al. 2002): shaken below break-away, LuGre's bristles drift and elasto-plastic ones do not.
TEST(Bristles, OnlyLuGreDriftsWhenShaken) {
    const auto drift = [](Presliding kind) {
        Gear gear{Bristles(kind, 1500.0, 2.0)};
        const auto shake = [&](int times) {
            for (int i = 0; i < times; ++i) {
                gear.push(0.06, 0.1, 0.01);
                gear.push(0.02, 0.1, 0.01);
            }
        };
        shake(20);
        const double before = gear.angle;
        shake(200);
        return gear.angle - before;
    };
    EXPECT_LT(std::abs(drift(Presliding::kElastoPlastic)), 1e-9);
    EXPECT_GT(drift(Presliding::kLuGre), 1e-4);
}

/// Left alone after a knock on the joint; energies at the times given.
std::vector<double> energies(const Truth& truth, const Nominal& nominal, const std::vector<double>& seconds) {
    Machine machine(truth, BuiltSprings(nominal, truth), 0.0);
    machine.push_joint(3.0);
    std::vector<double> energy{machine.energy()};
    for (const double duration : seconds) {
        machine.run(duration, [](double) { return Command{}; });
        energy.push_back(machine.energy());
    }
    return energy;
}

// Law: nothing is lost without friction, and with it energy only falls. Semi-implicit steps swing about the energy by about
// kStep * (highest frequency, 30/s) = 0.3 %; a slack cable's motor is at its stop or swings freely.
TEST(Machine, EnergyIsKeptWithoutFrictionAndFallsWithIt) {
    const Nominal nominal = rigs::straight(0.5, 0.3);
    Truth truth = rigs::as_drawn(nominal);
    const std::vector<double> parts(20, 0.05);
    const std::vector<double> sticking = energies(truth, nominal, parts);
    for (std::size_t i = 1; i < sticking.size(); ++i) EXPECT_LE(sticking[i], sticking[i - 1] * 1.003 + 1e-6) << i;
    EXPECT_LT(sticking.back(), 0.8 * sticking.front());
    truth.joint.viscous = 0.0;
    truth.joint.stop = kNever;
    for (SideTruth& side : truth.sides) side.mu = side.viscous = 0.0;
    truth.bristle = 1e-3;  // no bristle to bend
    // Up to the first return to a stop: 0.2 s is less than half a swing of 0.5 s.
    const std::vector<double> free = energies(truth, nominal, {0.05, 0.05, 0.05});
    for (const double energy : free) EXPECT_NEAR(energy, free.front(), 0.01 * free.front());
}

// Law: a capstan that wound in rests where load (1 + mu) = torque, and one left with less torque stays until load (1 - mu) exceeds it.
TEST(Machine, ACapstanStaysBetweenItsBreakAwayLoads) {
    const Nominal nominal = rigs::straight(0.5, 0.3);
    for (const Presliding kind : {Presliding::kElastoPlastic, Presliding::kLuGre}) {
        Truth truth = rigs::as_drawn(nominal);
        truth.presliding = kind;
        Machine machine(truth, BuiltSprings(nominal, truth), 0.0);
        const auto ramp = [&](double from, double to) {
            machine.run(4.0, [&](double t) {
                const double s = std::min(1.0, t / 3.5), motor = from + (to - from) * s * s * (3.0 - 2.0 * s);
                return Command{{motor, motor}, 0.0, 0.0};
            });
            return (0.5 + 0.3) * machine.theta(0);  // load: the joint stays at 0
        };
        // LuGre's creep and the viscous drag of 0.004 Nms at 0.3 rad/s: 1 % at most.
        EXPECT_NEAR(ramp(0.0, 1.0) * (1.0 + nominal.mu), 1.0, 0.01);
        const double load = 1.0 / (1.0 + nominal.mu);
        EXPECT_NEAR(ramp(1.0, 1.05 * load * (1.0 - nominal.mu)), load, 0.01);
        EXPECT_NEAR(ramp(1.05 * load * (1.0 - nominal.mu), 0.3), 0.3 / (1.0 - nominal.mu), 0.01);
        EXPECT_NEAR(machine.q(), 0.0, 1e-9);  // both sides equal
    }
}

TEST(Machine, CablesDoNotPushAndCapstansDoNotUnwindPastTheirStop) {
    const Nominal nominal = rigs::straight(0.5, 0.3);
    const Truth truth = rigs::as_drawn(nominal);
    Machine machine(truth, BuiltSprings(nominal, truth), 0.0);
    machine.run(3.0, [](double t) { return Command{{0.0, 0.0}, std::min(t, 1.0), 0.3}; });
    EXPECT_GT(machine.theta(0), -2e-3);  // pulled with 0.68 Nm against a stop of 2000 Nm/rad
    EXPECT_GT(machine.theta(1), -2e-3);  // slack
    const double g = nominal.ratio();
    EXPECT_NEAR(machine.q(), 1.0 / (g * g * 0.5), 0.02);
}

}  // namespace
}  // namespace fusee::plant
