#include "fixture.h"
#include "fusee/cam/contact.h"
#include "fusee/spring/law.h"

namespace fusee::cam {
namespace {

using namespace test;

/// K_PE of the paper's kind of law over its whole range, with a lead-in of 3 degrees: arms from 3 to 10 mm.
Cam steep_cam(int torque_sign, double direction) {
    const auto whole = spring::make_stiction_law({0.225, 0.0012, 0.265, 0.28, 0.6, 2.21}).value();
    const auto law = spring::with_lead_in(whole, core::rad_from_deg(3.0)).value();
    CamOptions o;
    o.torque_sign = torque_sign;
    o.guide.direction = direction;
    o.path.margin = core::rad_from_deg(75.0);
    o.path.min_idle_curvature_radius = 2.8e-3;
    return synthesize_cam({PartKind::kParallel, law, compression(7460.0, 0.0146), kCapstan}, o).value();
}

/// A disc of radius R about (e, 0) for a cable along +y, with these working angles: h = R + e cos psi.
Cam disc_cam(double radius, double offset, std::initializer_list<double> angles) {
    Cam cam;
    cam.kind = PartKind::kParallel;
    cam.rotation_sign = -1;
    cam.path = [=](double psi) { return PathPoint{psi, radius + offset * std::cos(psi), -offset * std::sin(psi), radius, 0.0}; };
    for (const double angle : angles) {
        Contact c;
        c.arm.angle = angle;
        c.path = cam.path(angle);
        cam.working.push_back(c);
    }
    return cam;
}

// Known: computed independently from the exported contour, 16, 6.5 and 1.7 %. All of it at the steep end of the law.
TEST(ParallelExit, SteepCamIsOffByTheKnownFigures) {
    const Cam cam = steep_cam(1, core::kPi / 2.0);
    for (const auto& [distance, percent] : {std::pair{0.15, 16.0}, {0.3, 6.5}, {1.0, 1.7}}) {
        const ExitError error = parallel_exit_error(cam, distance);
        EXPECT_NEAR(100.0 * error.relative, percent, 0.05) << distance;
        EXPECT_EQ(error.row, cam.working.size() - 1) << distance;
    }
}

// Known: the arm of the tangent from P to a circle of radius R about C. With arms 12 and 10 mm, the hole's line is 11 mm from the axis.
TEST(ParallelExit, TangentToADiscIsKnownByHand) {
    const double radius = 10e-3, offset = 2e-3, distance = 0.1, along = std::sqrt(distance * distance - 11e-3 * 11e-3);
    const ExitError error = parallel_exit_error(disc_cam(radius, offset, {0.0, core::kPi / 2.0}), distance);
    const auto arm = [&](double cx, double cy) {
        const double x = 11e-3 - cx, y = along - cy, normal = std::atan2(y, x) - std::acos(radius / std::hypot(x, y));
        return 11e-3 * std::cos(normal) + along * std::sin(normal);
    };
    EXPECT_EQ(error.row, 1u) << "turned by 90 deg, its centre is at (0, -2) mm";
    EXPECT_NEAR(error.relative, arm(0.0, -offset) / radius - 1.0, 1e-12);
    EXPECT_LT(std::abs(arm(offset, 0.0) / 12e-3 - 1.0), error.relative);
}

// Law: the error does not depend on the cable's direction, nor on the sense of the torque.
TEST(ParallelExit, DirectionAndSenseDoNotMatter) {
    const double error = parallel_exit_error(steep_cam(1, core::kPi / 2.0), 0.15).relative;
    EXPECT_NEAR(parallel_exit_error(steep_cam(1, -0.7), 0.15).relative, error, 1e-9);
    EXPECT_NEAR(parallel_exit_error(steep_cam(-1, 2.0), 0.15).relative, error, 1e-9);
}

TEST(ParallelExit, CircleAboutTheAxisHasNoErrorAndAHoleWithinTheCamNoCable) {
    const Cam round = disc_cam(10e-3, 0.0, {0.0, 1.0, 2.0});
    EXPECT_NEAR(parallel_exit_error(round, 0.02).relative, 0.0, 1e-14);
    EXPECT_EQ(least_parallel_distance(round, 1e-6, {0.02, 10.0}), 0.02);
    EXPECT_TRUE(std::isnan(parallel_exit_error(disc_cam(10e-3, 2e-3, {0.0, 3.0}), 9.99e-3).relative));
}

TEST(ParallelExit, LeastDistanceIsWhereTheErrorMeetsTheLimit) {
    const Cam cam = steep_cam(1, core::kPi / 2.0);
    const double least = least_parallel_distance(cam, 0.01, {0.05, 10.0});
    EXPECT_LE(parallel_exit_error(cam, least).relative, 0.01);
    EXPECT_GT(parallel_exit_error(cam, least * 0.998).relative, 0.01);
    EXPECT_EQ(least_parallel_distance(cam, 1e-4, {0.05, 1.0}), 1.0) << "not met within the range";
}

}  // namespace
}  // namespace fusee::cam
