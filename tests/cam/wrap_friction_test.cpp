#include "fusee/cam/wrap_friction.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fixture.h"
#include "refused.h"

namespace fusee::cam {
namespace {

using namespace test;

constexpr double kMu = 0.15, kStiffness = 5e3, kRadius = 12e-3, kPieceTurn = 1e-3;

/// Wound on a bollard over `turn` without tension.
WrappedCable bollard(double mu, double turn) {
    WrappedCable cable(mu, kStiffness);
    for (int i = 0; i < static_cast<int>(std::lround(turn / kPieceTurn)); ++i) cable.lay(kPieceTurn, kRadius * kPieceTurn, 0.0);
    return cable;
}

/// From one tension to another in steps; the area under tension over stretch [J].
double pull_slowly(WrappedCable& cable, double from, double to) {
    constexpr int kSteps = 400;
    double area = 0.0, last = cable.elongation();
    for (int i = 1; i <= kSteps; ++i) {
        const double tension = from + (to - from) * i / kSteps, step = (to - from) / kSteps;
        cable.pull(tension);
        area += (tension - 0.5 * step) * (cable.elongation() - last);
        last = cable.elongation();
    }
    return area;
}

// T R (1 - exp(-mu W))/(mu E A): the tension falls by Euler's exponential from the outer end.
TEST(WrappedCable, StretchesByEulersExponential) {
    WrappedCable cable = bollard(kMu, 4.0);
    cable.pull(50.0);
    // The exponential at the middles of pieces of 1 mrad: (mu 1 mrad)^2/24.
    EXPECT_NEAR(cable.elongation(), 50.0 * kRadius * (1.0 - std::exp(-kMu * 4.0)) / (kMu * kStiffness), 1e-9 * cable.elongation() + 1e-12);
}

TEST(WrappedCable, WithoutFrictionStretchesAsAStraightOneAndLosesNothing) {
    WrappedCable cable = bollard(0.0, 4.0);
    cable.pull(50.0);
    EXPECT_NEAR(cable.elongation(), 50.0 * kRadius * 4.0 / kStiffness, 1e-15);
    (void)pull_slowly(cable, 50.0, 10.0);
    (void)pull_slowly(cable, 10.0, 50.0);
    EXPECT_EQ(cable.dissipated(), 0.0);
}

// Between T1 and T2 with a wrap that holds, the stretch differs by R (sqrt T2 - sqrt T1)^2/(mu E A), the slip ends at ln(T2/T1)/(2 mu), and
// the loop has the area R/(mu E A) [u^4 - 2/3 (u1 + u2) u^3] from u1 = sqrt T1 to u2 = sqrt T2.
TEST(WrappedCable, LoopHasTheAreaKnownByHandAndThatIsDissipated) {
    const double low = 20.0, high = 50.0, u1 = std::sqrt(low), u2 = std::sqrt(high), unit = kRadius / (kMu * kStiffness);
    WrappedCable cable = bollard(kMu, 8.0);
    (void)pull_slowly(cable, 0.0, high);
    (void)pull_slowly(cable, high, low);
    const double stretched = cable.elongation(), lost = cable.dissipated();
    const double up = pull_slowly(cable, low, high);
    EXPECT_NEAR((cable.elongation() - stretched) / (unit * (u2 - u1) * (u2 - u1)), 1.0, 1e-4);  // pieces of 1 mrad in 3 rad of slip
    const double down = pull_slowly(cable, high, low);
    const auto primitive = [&](double u) { return std::pow(u, 4) - 2.0 / 3.0 * (u1 + u2) * std::pow(u, 3); };
    const double area = unit * (primitive(u2) - primitive(u1));
    // The loop is a thin difference of two large areas: 400 steps leave 1/400 of its first and last slip.
    EXPECT_NEAR((up + down) / area, 1.0, 5e-3);
    EXPECT_NEAR((cable.dissipated() - lost) / area, 1.0, 5e-3);
}

TEST(WrappedCable, NamesWhatItRefuses) {
    EXPECT_EQ(field_refused([] { return WrappedCable(-0.1, 1e3); }), "cable.friction");
    EXPECT_EQ(field_refused([] { return WrappedCable(0.1, 0.0); }), "cable.stiffness_N");
}

Cam planar(const ArmFunction& arm) { return synthesize_cam(arm, CamOptions{}).value(); }

// No friction: the same stretch both ways. More than any cable has: nothing slips, and the cable unwinds as it was wound.
TEST(WrapLoop, ClosesWithoutFrictionAndWithAllOfIt) {
    for (const ArmFunction& arm : {series_arm(), parallel_arm()}) {
        const Cam cam = planar(arm);
        for (const double mu : {0.0, 10.0}) {
            const WrapLoop loop = wrap_loop(cam, arm.base().rate, kCapstan, {mu, kStiffness});
            ASSERT_EQ(loop.rows.size(), cam.working.size());
            for (const WrapRow& row : loop.rows) EXPECT_NEAR(row.width(), 0.0, mu == 0.0 ? 1e-12 : 1e-4) << row.angle;
        }
    }
}

TEST(WrapLoop, LosesEnergyAndIsLongerOnTheWayDown) {
    for (const ArmFunction& arm : {series_arm(), parallel_arm()}) {
        const WrapLoop loop = wrap_loop(planar(arm), arm.base().rate, kCapstan, {kMu, kStiffness});
        EXPECT_GT(loop.dissipated, 0.0);
        double widest = 0.0;
        for (const WrapRow& row : loop.rows) {
            EXPECT_GE(row.width(), -1e-12) << row.angle;
            widest = std::max(widest, row.width());
        }
        EXPECT_GT(widest, 0.0);
        const WrapLoop stiffer = wrap_loop(planar(arm), arm.base().rate, kCapstan, {kMu, 2.0 * kStiffness});
        EXPECT_NEAR(stiffer.dissipated / loop.dissipated, 0.5, 1e-9);  // all elongation is in proportion to 1/(E A)
    }
}

}  // namespace
}  // namespace fusee::cam
