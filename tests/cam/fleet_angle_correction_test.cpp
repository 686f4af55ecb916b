#include <gtest/gtest.h>

#include <cmath>

#include "fixture.h"
#include "fusee/cam/arm.h"
#include "fusee/cam/cam.h"
#include "fusee/cam/certificate.h"

// At a fleet angle the torque on the cam is cos(fleet) times tension times arm: the arms of cams are longer by that.
namespace fusee::cam {
namespace {

using namespace test;

CamOptions with_guide_at(PathKind path, Lead lead, double z) {
    CamOptions o;
    o.guide = {GuideKind::kPoint, core::kPi / 2.0, 0.15, 0.0, 1, z};
    o.path.kind = path;
    o.path.lead = lead;
    o.path.pitch = 4e-3;
    return o;
}

/// Length of the wound cable between two directions, along the groove in space: midpoints.
double wound(const Cam& cam, double from, double to) {
    constexpr int kSteps = 400;
    const double step = (to - from) / kSteps;
    double length = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double psi = from + (i + 0.5) * step, h = 0.25 * step;
        length += step * std::hypot(cam.path(psi).rho, (cam.path(psi + h).z - cam.path(psi - h).z) / (2.0 * h));
    }
    return length;
}

/// Law: virtual work. A groove that points at its guide takes up as much cable as the arms asked for say; without the correction it would
/// miss 1 - cos(fleet), up to 0.9 % here. Differences and midpoints err by 1e-6.
TEST(FleetAngleCorrection, AimedGrooveTakesUpTheCableThatTheLawAsksFor) {
    for (const int sign : {1, -1}) {
        CamOptions o = with_guide_at(PathKind::kHelix, Lead::kAimedAtGuide, 0.02);
        o.torque_sign = sign;
        const Cam cam = synthesize_cam(long_parallel_arm(), o).value();
        const auto free = [&](const Contact& c) { return std::hypot(c.span, o.guide.z - c.path.z); };
        const std::size_t last = cam.working.size() - 1;
        for (const std::size_t from : {std::size_t{0}, last / 3, 2 * last / 3}) {
            const std::size_t to = from + last / 3;
            const Contact &a = cam.working[from], &b = cam.working[to];
            double asked = 0.0;  // of capstan travel: trapezia over 133 rows, 2e-6 of it
            for (std::size_t i = from; i < to; ++i)
                asked +=
                    0.5 * (cam.working[i].arm.arm + cam.working[i + 1].arm.arm) * (cam.working[i + 1].arm.angle - cam.working[i].arm.angle);
            const double drawn_in = sign * wound(cam, a.path.psi, b.path.psi) + free(b) - free(a);
            EXPECT_NEAR(drawn_in, asked, 2e-5 * asked) << from;
        }
    }
}

TEST(FleetAngleCorrection, ArmInThePlaneTimesItsCosineIsTheArmAskedFor) {
    for (const PartKind kind : {PartKind::kSeries, PartKind::kParallel})
        for (const CamOptions& o :
             {with_guide_at(PathKind::kPlanar, Lead::kConstantPitch, 0.008), with_guide_at(PathKind::kHelix, Lead::kAimedAtGuide, 0.02),
              with_guide_at(PathKind::kHelix, Lead::kConstantPitch, 0.005)}) {
            const ArmFunction arm = kind == PartKind::kSeries ? series_arm() : parallel_arm();
            const Cam cam = synthesize_cam(arm, o).value();
            for (const Contact& c : cam.working) {
                EXPECT_EQ(c.arm.arm, arm.at_load(c.arm.tau).arm);
                // A series of degree 16 for a cosine within 1 % of 1; the round that is left out changes it by 1e-7.
                EXPECT_NEAR(c.path.h * std::cos(c.fleet), c.arm.arm, 1e-6 * c.arm.arm);
                EXPECT_NEAR(cam.path(c.path.psi).h, c.path.h, 1e-12);
            }
            const Certificate proof = certify(cam);
            EXPECT_EQ(proof.convex, Proof::kProven) << proof.open;
            EXPECT_EQ(proof.ordered, Proof::kProven) << proof.open;
        }
}

TEST(FleetAngleCorrection, CableInItsPlaneIsLeftAsItIs) {
    const Cam level = synthesize_cam(parallel_arm(), with_guide_at(PathKind::kPlanar, Lead::kConstantPitch, 0.0)).value();
    for (const Contact& c : level.working) EXPECT_EQ(c.path.h, c.arm.arm);
    const Cam straight_off = synthesize_cam(series_arm(), CamOptions{}).value();
    for (const Contact& c : straight_off.working) EXPECT_EQ(c.path.h, c.arm.arm);
}

}  // namespace
}  // namespace fusee::cam
