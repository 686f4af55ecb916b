#include "fusee/cam/cam.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "fixture.h"
#include "refused.h"

namespace fusee::cam {
namespace {

using namespace test;

constexpr double kTurn = 2.0 * core::kPi;

CamOptions helix(double pitch) {
    CamOptions o;
    o.path.kind = PathKind::kHelix;
    o.path.pitch = pitch;
    return o;
}

/// h' and rho must be what h says: central differences (step 1e-5) err by 1e-10 of h'''.
void expect_consistent(const Cam& cam, double psi) {
    const double h = 1e-5;
    const PathPoint low = cam.path(psi - h), mid = cam.path(psi), high = cam.path(psi + h);
    EXPECT_NEAR((high.h - low.h) / (2 * h), mid.slope, 1e-6) << psi;
    EXPECT_NEAR((high.slope - low.slope) / (2 * h), mid.rho - mid.h, 2e-3 * mid.rho + 1e-6) << psi;
    EXPECT_GT(mid.rho, 0.0) << psi;
}

class PlanarCam : public ::testing::TestWithParam<PartKind> {
protected:
    Cam make(int torque_sign = 1) const {
        CamOptions o;
        o.torque_sign = torque_sign;
        return synthesize_cam(GetParam() == PartKind::kSeries ? series_arm() : parallel_arm(), o).value();
    }
};

TEST_P(PlanarCam, IsOneClosedConvexTurn) {
    const Cam cam = make();
    EXPECT_NEAR(cam.groove_psi.width(), kTurn, 1e-12);
    const PathPoint begin = cam.path(cam.groove_psi.low), end = cam.path(cam.groove_psi.low + kTurn);
    EXPECT_NEAR(begin.h, end.h, 1e-12);
    EXPECT_NEAR(begin.slope, end.slope, 1e-11);
    EXPECT_NEAR(begin.rho, end.rho, 1e-9);
    for (double share = 0.013; share < 1.0; share += 0.041) expect_consistent(cam, cam.groove_psi.low + share * kTurn);
}

TEST_P(PlanarCam, HasTheArmAskedForAtEveryWorkingAngle) {
    const Cam cam = make();
    ASSERT_GE(cam.working.size(), 200u);
    EXPECT_DOUBLE_EQ(cam.working.front().arm.angle, 0.0);
    for (const Contact& c : cam.working) {
        // Parallel guide along +y: the world normal is +x, so the body normal is minus the rotation.
        EXPECT_NEAR(c.path.psi, -cam.rotation_sign * c.arm.angle, 1e-12);
        EXPECT_NEAR(cam.path(c.path.psi).h, c.arm.arm, 1e-12);
    }
}

TEST_P(PlanarCam, MirrorsWithTheTorqueSign) {
    const Cam right = make(1), left = make(-1);
    for (double share = 0.1; share < 1.0; share += 0.2) {
        const double psi = right.working_psi.low + share * right.working_psi.width();
        EXPECT_NEAR(right.path(psi).h, left.path(core::kPi - psi).h, 1e-12);
        EXPECT_NEAR(right.path(psi).slope, -left.path(core::kPi - psi).slope, 1e-11);
    }
}

TEST_P(PlanarCam, AnchorIsOnTheWoundSideOutsideTheWorkingArc) {
    const Cam cam = make();
    const double before = cam.working_psi.low - cam.options.path.margin;
    EXPECT_NEAR(std::remainder(cam.anchor_psi - before, kTurn), 0.0, 1e-12);
    EXPECT_GT(cam.anchor_psi, cam.working_psi.high);
}

INSTANTIATE_TEST_SUITE_P(BothCams, PlanarCam, ::testing::Values(PartKind::kSeries, PartKind::kParallel),
                         [](const auto& instance) { return std::string(to_string(instance.param)); });

TEST(HelixCam, HoldsMoreThanATurnAndAHalf) {
    const Cam cam = synthesize_cam(long_parallel_arm(), helix(4e-3)).value();
    EXPECT_GT(cam.working_psi.width(), 1.5 * kTurn);
    EXPECT_NEAR(cam.path(cam.working_psi.low + kTurn).z - cam.path(cam.working_psi.low).z, 4e-3, 1e-12);
    for (double share = 0.017; share < 1.0; share += 0.031) expect_consistent(cam, cam.groove_psi.low + share * cam.groove_psi.width());
    EXPECT_GT(std::abs(std::remainder(cam.groove_psi.width(), kTurn)), 0.04);
}

// Law: aimed at the guide, the groove's slope along the cable equals the free cable's: dz/ds = (z_guide - z)/span.
TEST(HelixCam, AimedGroovePointsAtTheGuide) {
    CamOptions o = helix(0.0);
    o.path.lead = Lead::kAimedAtGuide;
    o.guide = {GuideKind::kPoint, core::kPi / 2.0, 0.15, 0.0, 1, 0.02};
    const Cam cam = synthesize_cam(long_parallel_arm(), o).value();
    for (std::size_t i = 20; i < cam.working.size() - 20; i += 40) {
        const Contact& c = cam.working[i];
        const double h = 1e-4, slope = (cam.path(c.path.psi + h).z - cam.path(c.path.psi - h).z) / (2 * h);
        EXPECT_NEAR(slope / c.path.rho, (o.guide.z - c.path.z) / c.span, 2e-4 * std::abs(slope / c.path.rho)) << i;
        EXPECT_NEAR(std::tan(c.fleet), (o.guide.z - c.path.z) / c.span, 1e-12);
    }
}

TEST(Cam, RefusesWithTheBindingLimit) {
    const auto rule_of = [](const core::Outcome<Cam>& cam) { return cam ? std::string("made") : cam.refusal().front().rule; };
    EXPECT_EQ(rule_of(synthesize_cam(long_parallel_arm(), CamOptions{})), "cam.wrap");
    CamOptions near;
    near.guide = {GuideKind::kPoint, 0.0, 0.009, 0.0, 1, 0.0};
    EXPECT_EQ(rule_of(synthesize_cam(parallel_arm(), near)), "cam.guide");
    // Towards higher loads the spool's arm falls faster and faster; past 2.5 Nm no convex contour follows.
    const auto too_far = spring::make_stiction_law({0.225, 0.0012, 0.265, 0.28, 0.6, 3.2}).value();
    const ArmFunction steep(PartKind::kSeries, too_far, torsion(), kCapstan);
    const auto refused = synthesize_cam(steep, CamOptions{});
    EXPECT_EQ(rule_of(refused), "cam.convexity");
    EXPECT_LE(refused.refusal().front().measured, 0.0);
    EXPECT_FALSE(refused.refusal().front().suggestion.empty());
}

// An unloaded spring, or one of another size than the law, needs arms that no cam has; the suggested change makes a cam possible.
TEST(Cam, RefusesArmsOfNoSizeAndNamesASpringThatSuits) {
    const auto suggested = [](const ArmFunction& arm, const char* format) {
        const auto refused = synthesize_cam(arm, CamOptions{});
        EXPECT_FALSE(refused);
        const core::Finding& f = refused.refusal().front();
        EXPECT_EQ(f.rule, "cam.arm");
        double value = 0.0;
        EXPECT_EQ(std::sscanf(f.suggestion.text().c_str(), format, &value), 1) << f.suggestion.text();
        return value;
    };
    const auto makes = [](const spring::BaseSpring& base, PartKind kind) {
        return bool(synthesize_cam(ArmFunction(kind, stiction_law(), base, kCapstan), CamOptions{}));
    };
    const auto with = [](const spring::BaseSpring& base, PartKind kind) { return ArmFunction(kind, stiction_law(), base, kCapstan); };
    const double y0 = suggested(with(compression(7460.0, 0.0), PartKind::kParallel), "k_pe.spring.preload_mm = %lf");
    EXPECT_TRUE(makes(compression(7460.0, 1e-3 * y0), PartKind::kParallel)) << y0;
    const double k = suggested(with(compression(1e9), PartKind::kParallel), "k_pe.spring.rate_N_per_m = %lf");
    const auto softer = synthesize_cam(with(compression(k), PartKind::kParallel), CamOptions{});
    EXPECT_NE(softer ? "made" : softer.refusal().front().rule, "cam.arm") << k;
    EXPECT_GT(suggested(with(torsion(0.0183, 0.0), PartKind::kSeries), "k_se.spring.preload_rad = %lf"), 0.0);
}

TEST(Cam, NamesTheBadOption) {
    const auto field_of = [](const CamOptions& o) { return field_refused([&] { return synthesize_cam(parallel_arm(), o); }); };
    CamOptions o;
    o.torque_sign = 0;
    EXPECT_EQ(field_of(o), "k_pe.torque_sign");
    o = {};
    o.target_rows = 10;
    EXPECT_EQ(field_of(o), "k_pe.target_rows");
    EXPECT_EQ(field_of(helix(0.0)), "k_pe.path.pitch_mm");
    o = helix(4e-3);
    o.path.lead = Lead::kAimedAtGuide;
    EXPECT_EQ(field_of(o), "k_pe.path.lead");
}

}  // namespace
}  // namespace fusee::cam
