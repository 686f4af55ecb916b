#include "fusee/cam/mirror.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

#include "fixture.h"
#include "fusee/cam/certificate.h"
#include "fusee/core/units.h"
#include "refused.h"

namespace fusee::cam {
namespace {

using namespace test;

struct Place {
    const char* name;
    Guide guide;
};
void PrintTo(const Place& place, std::ostream* out) { *out << place.name; }

CamOptions helix_of_pitch(double pitch, Hand hand = Hand::kRight) {
    CamOptions o;
    o.path.kind = PathKind::kHelix;
    o.path.pitch = pitch;
    o.path.hand = hand;
    return o;
}

/// Solved twice by roots to 1e-13 of a load, h' and rho are the steeper functions of it.
void expect_same(const PathPoint& a, const PathPoint& b) {
    EXPECT_NEAR(a.psi, b.psi, 1e-12);
    EXPECT_NEAR(a.h, b.h, 1e-13);
    EXPECT_NEAR(a.slope, b.slope, 1e-11);
    EXPECT_NEAR(a.rho, b.rho, 1e-8);
    EXPECT_NEAR(a.z, b.z, 1e-12);
}

/// @param psi where both paths are known
void expect_same(const Cam& a, const Cam& b, core::Range psi) {
    EXPECT_EQ(a.rotation_sign, b.rotation_sign);
    EXPECT_EQ(a.options.torque_sign, b.options.torque_sign);
    EXPECT_NEAR(a.working_psi.low, b.working_psi.low, 1e-12);
    EXPECT_NEAR(a.working_psi.high, b.working_psi.high, 1e-12);
    EXPECT_NEAR(a.groove_psi.low, b.groove_psi.low, 1e-12);
    EXPECT_NEAR(a.anchor_psi, b.anchor_psi, 1e-12);
    for (int i = 0; i <= 97; ++i) expect_same(a.path(psi.low + psi.width() * i / 97), b.path(psi.low + psi.width() * i / 97));
    ASSERT_EQ(a.working.size(), b.working.size());
    for (std::size_t i = 0; i < a.working.size(); i += 13) {
        EXPECT_NEAR(a.working[i].arm.angle, b.working[i].arm.angle, 1e-12);
        EXPECT_NEAR(a.working[i].span, b.working[i].span, 1e-12);
        EXPECT_NEAR(a.working[i].fleet, b.working[i].fleet, 1e-12);
        expect_same(a.working[i].path, b.working[i].path);
    }
}

class Mirrored : public ::testing::TestWithParam<Place> {};
INSTANTIATE_TEST_SUITE_P(Guides, Mirrored,
                         ::testing::Values(Place{"parallel", {GuideKind::kParallel, 1.2}}, Place{"point", {GuideKind::kPoint, 0.7, 0.12}},
                                           Place{"idler_left", {GuideKind::kIdler, 0.7, 0.12, 0.01, 1}},
                                           Place{"idler_right", {GuideKind::kIdler, 0.7, 0.12, 0.01, -1}}),
                         [](const auto& one) { return std::string(one.param.name); });

// Two ways to the same cam: mirror what was synthesized, or synthesize for the mirrored guide and sense.
TEST_P(Mirrored, IsTheCamOfTheMirroredOptions) {
    for (const ArmFunction& arm : {series_arm(), parallel_arm()}) {
        CamOptions o;
        o.guide = GetParam().guide;
        const Cam cam = synthesize_cam(arm, o).value(), other = synthesize_cam(arm, mirrored(o)).value();
        expect_same(mirrored(cam), other, other.groove_psi);
        expect_same(mirrored(mirrored(cam)), cam, cam.groove_psi);
    }
}

/// The same bounds, bit for bit.
void expect_equal(const LeastRadius& a, const LeastRadius& b) {
    EXPECT_EQ(a.proven, b.proven);
    EXPECT_EQ(a.found, b.found);
    EXPECT_EQ(a.psi.low, b.psi.low);
    EXPECT_EQ(a.psi.high, b.psi.high);
}

// Two ways to the image's certificate: mirror the part's, or certify the image. Interval arithmetic rounds the same on both sides.
TEST_P(Mirrored, HasTheCertificateOfItsImage) {
    for (const PathKind path : {PathKind::kPlanar, PathKind::kHelix}) {
        CamOptions o = path == PathKind::kHelix ? helix_of_pitch(0.004) : CamOptions{};
        o.guide = GetParam().guide;
        const Cam cam = synthesize_cam(series_arm(), o).value(), image = mirrored(cam);
        const Certificate taken = mirrored(certify(cam), image), made = certify(image);
        EXPECT_EQ(taken.convex, Proof::kProven);
        EXPECT_EQ(taken.ordered, Proof::kProven);
        EXPECT_EQ(made.convex, Proof::kProven);
        EXPECT_EQ(made.ordered, Proof::kProven);
        expect_equal(taken.working, made.working);
        expect_equal(taken.idle.value(), made.idle.value());
        ASSERT_EQ(taken.floor.has_value(), made.floor.has_value());
        if (taken.floor) expect_equal(*taken.floor, *made.floor);
        EXPECT_EQ(taken.seam, made.seam);
        EXPECT_EQ(taken.boxes, made.boxes);
    }
}

// Known: reflected in the plane y = 0, point by point.
TEST_P(Mirrored, HasItsContactsOnTheOtherSide) {
    CamOptions o;
    o.guide = GetParam().guide;
    const Cam cam = synthesize_cam(series_arm(), o).value(), other = mirrored(cam);
    EXPECT_EQ(other.rotation_sign, -cam.rotation_sign);
    EXPECT_DOUBLE_EQ(other.options.guide.direction, -o.guide.direction);
    for (std::size_t i = 0; i < cam.working.size(); i += 7) {
        const PathPoint &p = cam.working[i].path, &q = other.working[i].path;
        EXPECT_DOUBLE_EQ(q.x(), p.x());
        EXPECT_DOUBLE_EQ(q.y(), -p.y());
        EXPECT_DOUBLE_EQ(other.working[i].arm.arm, cam.working[i].arm.arm);
    }
}

// The proof of a contour holds for its image, by the image's own formulas.
TEST_P(Mirrored, HasTheSameCertificate) {
    CamOptions o;
    o.guide = GetParam().guide;
    const Cam cam = synthesize_cam(parallel_arm(), o).value();
    const Certificate certificate = certify(cam), image = certify(mirrored(cam));
    EXPECT_EQ(image.convex, Proof::kProven) << image.open;
    EXPECT_EQ(image.ordered, Proof::kProven) << image.open;
    EXPECT_DOUBLE_EQ(image.working.proven, certificate.working.proven);
    EXPECT_DOUBLE_EQ(image.working.psi.low, -certificate.working.psi.high);
    EXPECT_DOUBLE_EQ(image.idle->proven, certificate.idle->proven);
    EXPECT_LT(image.seam, 1e-10);
}

TEST(Mirrored, OfAHelixHasTheOtherHand) {
    const Cam right = synthesize_cam(long_parallel_arm(), helix_of_pitch(4e-3)).value(), left = mirrored(right);
    EXPECT_FALSE(left_handed(right));
    EXPECT_TRUE(left_handed(left));
    EXPECT_EQ(left.options.path.hand, Hand::kLeft);
    expect_same(left, synthesize_cam(long_parallel_arm(), left.options).value(), left.groove_psi);
    expect_same(mirrored(left), right, right.groove_psi);
}

// An aimed groove leads to its guide on either side: its image is the cam of the mirrored options.
TEST(Mirrored, OfAnAimedHelixStillPointsAtItsGuide) {
    for (const double z : {0.02, -0.02}) {
        CamOptions o = helix_of_pitch(0.0);
        o.path.lead = Lead::kAimedAtGuide;
        o.guide = {GuideKind::kPoint, core::kPi / 2.0, 0.15, 0.0, 1, z};
        const Cam cam = synthesize_cam(long_parallel_arm(), o).value(), other = mirrored(cam);
        EXPECT_EQ(other.options.path.hand, Hand::kRight) << "not chosen: the guide's height gives it";
        EXPECT_EQ(left_handed(cam), z < 0.0);
        EXPECT_NE(left_handed(other), left_handed(cam));
        const Cam made = synthesize_cam(long_parallel_arm(), mirrored(o)).value();
        for (std::size_t i = 0; i < made.working.size(); i += 20) expect_same(other.working[i].path, made.working[i].path);
    }
}

// Known: the hand changes heights alone. Right-handed z = p (psi - low)/turn, left-handed z = p (high - psi)/turn.
TEST(LeftHand, ChangesHeightsAlone) {
    for (const int torque_sign : {1, -1}) {
        CamOptions o = helix_of_pitch(4e-3), other = helix_of_pitch(4e-3, Hand::kLeft);
        o.torque_sign = other.torque_sign = torque_sign;
        const Cam right = synthesize_cam(long_parallel_arm(), o).value(), left = synthesize_cam(long_parallel_arm(), other).value();
        EXPECT_EQ(left.options.torque_sign, torque_sign);
        EXPECT_EQ(left.options.path.hand, Hand::kLeft);
        EXPECT_EQ(left.rotation_sign, right.rotation_sign);
        for (std::size_t i = 0; i < right.working.size(); i += 11) {
            const PathPoint &a = right.working[i].path, &b = left.working[i].path;
            EXPECT_NEAR(b.x(), a.x(), 1e-12);
            EXPECT_NEAR(b.y(), a.y(), 1e-12);
            EXPECT_NEAR(a.z, 4e-3 * (a.psi - right.working_psi.low) / core::kTurn, 1e-12);
            EXPECT_NEAR(b.z, 4e-3 * (right.working_psi.high - b.psi) / core::kTurn, 1e-12);
        }
        const Certificate proof = certify(left);
        EXPECT_EQ(proof.convex, Proof::kProven) << proof.open;
        EXPECT_NEAR(proof.floor->proven, certify(right).floor->proven, 1e-12);
    }
}

TEST(LeftHand, IsNotAChoiceForAnAimedGroove) {
    CamOptions o = helix_of_pitch(0.0, Hand::kLeft);
    o.path.lead = Lead::kAimedAtGuide;
    o.guide = {GuideKind::kPoint, core::kPi / 2.0, 0.15, 0.0, 1, 0.02};
    EXPECT_EQ(field_refused([&] { return synthesize_cam(long_parallel_arm(), o); }), "k_pe.path.hand");
}

}  // namespace
}  // namespace fusee::cam
