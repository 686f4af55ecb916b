#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "fixture.h"
#include "fusee/cam/cam.h"
#include "fusee/cam/certificate.h"
#include "fusee/cam/contact.h"
#include "fusee/cam/mirror.h"
#include "fusee/core/units.h"
#include "refused.h"

namespace fusee::cam {
namespace {

using namespace test;

CamOptions roller_options(double offset = 0.0, int torque_sign = 1) {
    CamOptions options;
    options.family = Family::kRoller;
    options.cable_diameter = 0.0;
    options.torque_sign = torque_sign;
    options.roller.radius = 6e-3;
    options.roller.base_radius = 30e-3;
    options.roller.offset = offset;
    return options;
}

/// A disc pushes a roller whose centre stays radius + R_r from the disc's own. Its centre stands `eccentric` from the axis and, at cam
/// angle 0, `lead` beyond the follower's line on the side to which the offset is counted; the cam turns it back.
struct EccentricDisc {
    double radius, eccentric, lead;

    [[nodiscard]] ArmPoint at(double a, const Roller& roller) const {
        const double apart = radius + roller.radius, along = eccentric * std::cos(lead - a), across = eccentric * std::sin(lead - a);
        const double beside = across - roller.offset, root = std::sqrt(apart * apart - beside * beside);
        ArmPoint p;
        p.angle = a;
        p.travel = along + root - follower_start(roller);
        p.arm = across + beside * along / root;
        p.slope = -along - (along * along - beside * across) / root - beside * beside * along * along / (root * root * root);
        return p;
    }
};

class RollerOnDisc : public testing::TestWithParam<std::pair<double, int>> {};

// The rim is the disc itself: rho its radius, and h that of a circle about (eccentric, lead).
TEST_P(RollerOnDisc, TouchesTheDiscEverywhere) {
    const auto [offset, torque_sign] = GetParam();
    const CamOptions options = roller_options(offset, torque_sign);
    const EccentricDisc disc{35e-3, 8e-3, 2.6};
    const double centre = options.roller.direction + torque_sign * disc.lead;  // in the body, where the line stands at angle 0
    for (double a = 0.0; a < 2.0; a += 0.1) {
        const ArmPoint arm = disc.at(a, options.roller);
        const Contact c = touch(PartKind::kParallel, arm, options);
        EXPECT_NEAR(c.path.rho, disc.radius, 1e-12);
        const double body = c.path.psi - centre;  // from the disc's centre
        EXPECT_NEAR(c.path.h, disc.radius + disc.eccentric * std::cos(body), 1e-12) << a;
        EXPECT_NEAR(c.path.slope, -disc.eccentric * std::sin(body), 1e-12) << a;
    }
}

INSTANTIATE_TEST_SUITE_P(Lines, RollerOnDisc,
                         testing::Values(std::pair{0.0, 1}, std::pair{0.0, -1}, std::pair{4e-3, 1}, std::pair{-3e-3, -1}));

/// The roller pushed against a rim of points: its centre along the line [m].
double pushed(const std::vector<PathPoint>& rim, const CamOptions& options, double cam_angle) {
    const double turned = -options.torque_sign * cam_angle, back = options.roller.direction - turned;
    double s = 0.0;
    for (const PathPoint& p : rim) {
        const double along = p.x() * std::cos(back) + p.y() * std::sin(back);
        const double beside = options.torque_sign * (p.y() * std::cos(back) - p.x() * std::sin(back)) - options.roller.offset;
        if (std::abs(beside) < options.roller.radius)
            s = std::max(s, along + std::sqrt(options.roller.radius * options.roller.radius - beside * beside));
    }
    return s;
}

// Turn the rim and push the roller against it: the spring has the compression of the law.
TEST(Roller, RimMovesTheFollowerAsTheLawAsks) {
    for (const auto& [offset, sign] : {std::pair{0.0, 1}, {5e-3, -1}}) {
        const CamOptions options = roller_options(offset, sign);
        const auto cam = synthesize_cam(parallel_arm(), options);
        ASSERT_TRUE(cam) << core::to_line(cam.refusal().front());
        std::vector<PathPoint> rim;
        for (int i = 0; i < 40000; ++i) rim.push_back(cam->path(cam->groove_psi.low + core::kTurn * i / 40000));
        const double start = follower_start(options.roller);
        for (std::size_t i = 0; i < cam->working.size(); i += 57) {
            const ArmPoint& arm = cam->working[i].arm;
            // Points are 6 um apart: a roller of 6 mm sinks in by (3 um)^2/(2 R) (1/R_r + 1/rho) < 2 nm between them.
            EXPECT_NEAR(pushed(rim, options, arm.angle) - start, arm.travel, 2e-9) << arm.angle;
        }
    }
}

TEST(Roller, ClosesWithoutACornerAndIsProvenConvex) {
    const auto cam = synthesize_cam(parallel_arm(), roller_options());
    ASSERT_TRUE(cam);
    const Certificate certificate = certify(*cam);
    EXPECT_EQ(certificate.convex, Proof::kProven) << certificate.open;
    EXPECT_EQ(certificate.ordered, Proof::kProven);
    EXPECT_LT(certificate.seam, 1e-9);
    double least = 1.0;
    for (const Contact& c : cam->working) least = std::min(least, c.path.rho);
    EXPECT_LE(certificate.working.proven, least);
    EXPECT_GE(certificate.working.proven, 0.999 * least);  // 400 rows find the least radius to a thousandth
}

TEST(Roller, OffsetEasesThePressureAngle) {
    ArmPoint arm;
    arm.arm = 20e-3;
    arm.travel = 10e-3;
    EXPECT_NEAR(pressure_angle(arm, roller_options()), std::atan(20.0 / 46.0), 1e-12);
    EXPECT_NEAR(std::tan(pressure_angle(arm, roller_options(8e-3))), 12e-3 / (std::sqrt(36e-3 * 36e-3 - 64e-6) + 10e-3), 1e-12);
}

// Two steel cylinders of 10 and 40 mm radius, 5 mm long, under 100 N: 1/R = 0.125/mm, p = sqrt(100 N 115 GPa/(pi 5 mm) 0.125/mm).
TEST(Roller, ContactPressureIsThatOfHertz) {
    ArmPoint arm;
    arm.tension = 100.0;  // no arm, no slope: the roller rests on a circle about the axis
    CamOptions options;
    options.roller = {.radius = 10e-3, .base_radius = 40e-3, .width = 5e-3, .contact_modulus = 115e9};
    EXPECT_NEAR(pitch_radius(arm, options), 50e-3, 1e-15);
    EXPECT_NEAR(contact_pressure(arm, options) / 302.5e6, 1.0, 1e-3);
}

TEST(Roller, HollowRimIsRefusedWithABaseThatIsWideEnough) {
    CamOptions options = roller_options();
    options.roller.base_radius = 2e-3;
    options.roller.radius = 12e-3;
    const auto refused = synthesize_cam(parallel_arm(), options);
    ASSERT_FALSE(refused);
    const core::Finding& f = refused.refusal().front();
    EXPECT_TRUE(f.rule == "cam.convexity" || f.rule == "cam.idle_arc") << f.rule;
    const std::string key = "k_pe.roller.base_radius_mm = ";
    const auto at = f.suggestion.text().find(key);
    ASSERT_NE(at, std::string::npos) << f.suggestion.text();
    options.roller.base_radius = 1e-3 * std::stod(f.suggestion.text().substr(at + key.size()));
    EXPECT_TRUE(synthesize_cam(parallel_arm(), options));
}

TEST(Roller, ImpossibleFollowersAreNamed) {
    EXPECT_EQ(field_refused([] { return synthesize_cam(series_arm(), roller_options()); }), "k_se.family");
    EXPECT_EQ(field_refused([] {
                  CamOptions options = roller_options();
                  options.path.kind = PathKind::kHelix;
                  return synthesize_cam(parallel_arm(), options);
              }),
              "k_pe.path.kind");
    EXPECT_EQ(field_refused([] { return synthesize_cam(parallel_arm(), roller_options(40e-3)); }), "k_pe.roller.offset_mm");
}

TEST(Roller, MirroredCamIsTheOneOfTheMirroredFollower) {
    CamOptions options = roller_options(4e-3);
    options.roller.direction = 0.4;
    const Cam reflected = mirrored(synthesize_cam(parallel_arm(), options).value());
    const Cam own = synthesize_cam(parallel_arm(), mirrored(options)).value();
    for (double psi = own.groove_psi.low; psi < own.groove_psi.high; psi += 0.3) {
        EXPECT_NEAR(reflected.path(psi).h, own.path(psi).h, 1e-9) << psi;
        EXPECT_NEAR(reflected.path(psi).slope, own.path(psi).slope, 1e-9) << psi;
    }
}

}  // namespace
}  // namespace fusee::cam
