#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "fixture.h"
#include "fusee/cam/arm.h"
#include "fusee/core/error.h"

namespace fusee::cam {
namespace {

using namespace test;

std::vector<FoundArm> round_cam(double arm, double travel, int rows) {
    std::vector<FoundArm> found;
    for (int i = 0; i < rows; ++i) found.push_back({travel * i / (rows - 1), arm});
    return found;
}

std::vector<FoundArm> arms_of(const ArmFunction& cam, int rows, double share = 1.0) {
    const core::Range loads = cam.law().loads();
    std::vector<FoundArm> found;
    for (int i = 0; i < rows; ++i) {
        const ArmPoint p = cam.at_load(loads.low + loads.width() * i / (rows - 1));
        found.push_back({p.angle, share * p.arm});
    }
    return found;
}

// Known: a round cam of radius r on a linear spring is a linear spring. K_PE: F = k (y0 + r theta) r. K_SE: theta = r phi/r_c, so
// F = k_t (phi0 + theta r_c/r) r_c/r. On straight lines the interpolant has rounding errors only.
TEST(SpringOfArms, RoundCamOnALinearSpringIsALinearSpring) {
    const double r = 0.012, k = 3000.0, y0 = 0.004, kt = 0.02, phi0 = 3.0;
    const auto parallel = spring_of_arms(PartKind::kParallel, round_cam(r, 2.0, 30), compression(k, y0), kCapstan);
    const auto series = spring_of_arms(PartKind::kSeries, round_cam(r, 2.0, 30), torsion(kt, phi0), kCapstan);
    EXPECT_DOUBLE_EQ(parallel->domain().high, 2.0);
    EXPECT_NEAR(series->domain().high, 2.0 * r / kCapstan, 1e-15);
    for (const double x : {0.0, 0.21, 0.5, 0.77}) {
        EXPECT_NEAR(parallel->force(x), k * (y0 + r * x) * r, 1e-13) << x;
        EXPECT_NEAR(parallel->stiffness(x), k * r * r, 1e-11) << x;
        EXPECT_NEAR(parallel->energy(x), 0.5 * k * (r * x) * (2.0 * y0 + r * x), 1e-13) << x;
        const double turned = x * kCapstan / r;
        EXPECT_NEAR(series->force(x), kt * (phi0 + turned) * kCapstan / r, 1e-13) << x;
        EXPECT_NEAR(series->energy(x), 0.5 * kt * turned * (2.0 * phi0 + turned), 1e-13) << x;
    }
}

// Roundtrip: law to arms to law. 400 rows of a smooth law: the quintic's error is far below; 1e-9 of the torque is left to both.
TEST(SpringOfArms, GivesBackTheLawThatTheArmsWereMadeFrom) {
    const auto law = stiction_law();
    const auto series = spring_of_arms(PartKind::kSeries, arms_of(series_arm(), 400), torsion(), kCapstan);
    const auto parallel = spring_of_arms(PartKind::kParallel, arms_of(parallel_arm(), 400), compression(), kCapstan);
    EXPECT_NEAR(series->domain().high, law->angles().high, 1e-9);
    for (int i = 0; i <= 50; ++i) {
        const double x = law->angles().high * i / 50;
        const spring::LawPoint p = law->at_angle(x);
        EXPECT_NEAR(series->force(x), p.f_se, 1e-9 * p.f_se) << x;
        EXPECT_NEAR(parallel->force(x), p.f_pe, 1e-9 * p.f_pe) << x;
        EXPECT_NEAR(series->energy(x), p.u_se, 1e-9 * p.u_se + 1e-12) << x;
        EXPECT_NEAR(parallel->energy(x), p.u_pe, 1e-9 * p.u_pe + 1e-12) << x;
    }
}

// Law: arms larger by a share e of a preloaded round cam. K_PE has F = k (y0 + (1+e) r x)(1+e) r.
TEST(SpringOfArms, ArmsOnePercentTooLargeGiveTheTorqueKnownByHand) {
    const double r = 0.012, k = 3000.0, y0 = 0.004, wide = 1.01 * r;
    const auto spring = spring_of_arms(PartKind::kParallel, round_cam(wide, 2.0, 30), compression(k, y0), kCapstan);
    for (const double x : {0.0, 1.0, 2.0}) EXPECT_NEAR(spring->force(x), k * (y0 + wide * x) * wide, 1e-13) << x;
}

// The allowance is added to the spring again: a cam for a thicker or elastic cable carries the law on that rig.
TEST(SpringOfArms, WithItsAllowanceCarriesTheLaw) {
    const Allowance allowance{0.2e-3, 0.01};
    const auto law = stiction_law();
    const ArmFunction cut(PartKind::kSeries, law, torsion(), kCapstan, allowance);
    const auto series = spring_of_arms(PartKind::kSeries, arms_of(cut, 400), torsion(), kCapstan, allowance);
    for (const double x : {0.0, 0.3, 0.9}) EXPECT_NEAR(series->force(x), law->at_angle(x).f_se, 1e-9) << x;
    const auto without = spring_of_arms(PartKind::kSeries, arms_of(cut, 400), torsion(), kCapstan);
    EXPECT_GT(std::abs(without->force(0.3) - law->at_angle(0.3).f_se), 1e-3);
}

TEST(SpringOfArms, RefusesImpossibleArms) {
    auto arms = round_cam(0.012, 2.0, 30);
    const auto refused = [&] {
        try {
            (void)spring_of_arms(PartKind::kSeries, arms, torsion(), kCapstan);
        } catch (const core::InvalidInput& error) {
            return error.field();
        }
        return std::string("nothing");
    };
    EXPECT_EQ(refused(), "nothing");
    arms[3].arm = -0.001;
    EXPECT_EQ(refused(), "arms[3]");
    arms[3].arm = std::nan("");
    EXPECT_EQ(refused(), "arms[3]");
    arms[3] = {arms[2].angle, 0.012};
    EXPECT_EQ(refused(), "angle[3]");
    arms.resize(3);
    EXPECT_EQ(refused(), "angle");
}

}  // namespace
}  // namespace fusee::cam
