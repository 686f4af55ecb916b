#include <gtest/gtest.h>

#include <cmath>

#include "fusee/plant/machine.h"
#include "plant/rigs.h"

namespace fusee::plant {
namespace {

constexpr double kSe = 0.5, kPe = 0.3;  // [Nm/rad]

/// Series spring of a side that differs from the drawing in `change`.
template <class Change>
TorqueTable series(const Change& change) {
    const Nominal nominal = rigs::straight(kSe, kPe);
    SideTruth side = rigs::as_drawn(nominal).sides[0];
    change(side);
    return build_series(nominal, side);
}
template <class Change>
TorqueTable parallel(const Change& change) {
    const Nominal nominal = rigs::straight(kSe, kPe);
    SideTruth side = rigs::as_drawn(nominal).sides[0];
    change(side);
    return build_parallel(nominal, side);
}

// Law: cams cut to the drawing, on base springs as drawn, give the law back, whatever it is. The trapezoidal rules leave about
// 2e-5 rad of deflection, times up to 2 Nm/rad.
TEST(Spring, CutToTheDrawingItIsTheLaw) {
    for (const LawKind kind : {LawKind::kStictionCompensating, LawKind::kExponential, LawKind::kCubic}) {
        Random random(3, static_cast<std::uint64_t>(kind), 9);
        Nominal nominal;
        nominal.springs = draw_springs(kind, nominal.mu, 2.4, random);
        nominal.torsion_rate = 0.3;
        nominal.compression_rate = 1800.0;
        const SideTruth side = rigs::as_drawn(nominal).sides[0];
        const TorqueTable se = build_series(nominal, side), pe = build_parallel(nominal, side);
        const SpringCurves& law = nominal.springs;
        for (double share = 0.02; share < 1.0; share += 0.02) {
            const double x = share * law.deflection.back();
            EXPECT_NEAR(se.at(x), torque_at(law.deflection, law.se, x), 5e-5) << x;
            EXPECT_NEAR(pe.at(x), torque_at(law.deflection, law.pe, x), 5e-5) << x;
        }
        EXPECT_EQ(se.at(-0.1), 0.0);
    }
}

// Known: a straight spring's arm r is the same everywhere; F = k_t s/(r + dr)^2 r_c... goes with (r/(r + dr))^2 for K_SE, whose cable winds
// on the arm, and with ((r + dr)/r)^2 for K_PE, whose cam is turned.
TEST(Spring, ALongerArmSoftensKseAndStiffensKpe) {
    const Nominal nominal = rigs::straight(kSe, kPe);
    const double se_arm = nominal.capstan_radius * std::sqrt(nominal.torsion_rate / kSe),
                 pe_arm = std::sqrt(kPe / nominal.compression_rate);
    const TorqueTable se = series([](SideTruth& s) { s.se.radius_offset = 1e-3; });
    const TorqueTable pe = parallel([](SideTruth& s) { s.pe.radius_offset = 1e-3; });
    EXPECT_NEAR(se.at(2.0), kSe * 2.0 * std::pow(se_arm / (se_arm + 1e-3), 2), 1e-5);
    EXPECT_NEAR(pe.at(2.0), kPe * 2.0 * std::pow((pe_arm + 1e-3) / pe_arm, 2), 1e-5);
}

TEST(Spring, RatePreloadAndStretchAsByHand) {
    EXPECT_NEAR(series([](SideTruth& s) { s.se.rate *= 1.1; }).at(1.5), 1.1 * kSe * 1.5, 1e-6);
    // Wound by phi0: the spool's angle is x sqrt(F'/k_t), so the law starts phi0/sqrt(F'/k_t) ahead.
    const double ahead = 0.2 / std::sqrt(kSe / 0.4);
    EXPECT_NEAR(series([](SideTruth& s) { s.se.preload = 0.2; }).at(1.0), kSe * (1.0 + ahead), 1e-5);
    const TorqueTable slack = series([](SideTruth& s) { s.se.preload = -0.2; });
    EXPECT_EQ(slack.at(0.9 * ahead), 0.0);
    EXPECT_NEAR(slack.at(1.0), kSe * (1.0 - ahead), 1e-5);
    EXPECT_NEAR(series([](SideTruth& s) { s.se.cable_stiffness = 1.5; }).at(2.0), 2.0 / (1.0 / kSe + 1.0 / 1.5), 1e-5);
}

TEST(Spring, BindsPastItsBottomAndStepsAtACrack) {
    const double arm = std::sqrt(kPe / 2000.0);  // compression is arm * theta
    const TorqueTable bound = parallel([&](SideTruth& s) { s.pe.bottoming = arm; });
    EXPECT_NEAR(bound.at(0.9), kPe * 0.9, 1e-6);
    EXPECT_NEAR(bound.at(1.5), kPe * (1.5 + 20.0 * 0.5), 1e-4);
    const TorqueTable cracked = parallel([](SideTruth& s) {
        s.pe.crack_at = 1.0;
        s.pe.crack_share = 0.2;
    });
    EXPECT_NEAR(cracked.at(0.95), kPe * 0.95, 1e-6);
    EXPECT_NEAR(cracked.at(2.0), 0.8 * kPe * (1.0 + 0.8 * 1.0), 1e-3);  // half a row's width of the step
}

TEST(Spring, HysteresisIsTheShareBothWaysAndCreepRelaxes) {
    SpringTruth truth;
    truth.hysteresis = 0.1;
    Spring lossy(series([](SideTruth&) {}), truth);
    double up = 0.0;
    for (double x = 0.0; x <= 1.0; x += 1e-3) up = lossy.pull(x, 1e-3);
    double down = 0.0;
    for (double x = 1.0; x >= 0.7; x -= 1e-3) down = lossy.pull(x, 1e-3);
    EXPECT_NEAR(up, kSe * 1.1, 2e-3);
    EXPECT_NEAR(down, kSe * 0.7 * 0.9, 2e-3);
    truth = {};
    truth.creep_share = 0.3;
    truth.creep_time = 1.0;
    Spring creeping(series([](SideTruth&) {}), truth);
    EXPECT_NEAR(creeping.pull(1.0, 1e-3), 1.3 * kSe, 1e-3);
    double later = 0.0;
    for (int i = 0; i < 1000; ++i) later = creeping.pull(1.0, 1e-3);
    EXPECT_NEAR(later, kSe * (1.0 + 0.3 * std::exp(-1.0)), 1e-3);
}

}  // namespace
}  // namespace fusee::plant
