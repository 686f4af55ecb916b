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

// A roller on an arm. The expected places follow here from the linkage alone, in the world's coordinates, without pressure angles.
namespace fusee::cam {
namespace {

using namespace test;

struct Vec {
    double x, y;
};

CamOptions arm_options(int side = 1, int torque_sign = 1) {
    CamOptions options;
    options.family = Family::kRoller;
    options.cable_diameter = 0.0;
    options.torque_sign = torque_sign;
    options.roller.follower = FollowerKind::kArm;
    options.roller.radius = 6e-3;
    options.roller.base_radius = 30e-3;
    options.roller.direction = 0.3;
    options.roller.arm = {.length = 50e-3, .pivot = 62e-3, .side = side, .lever = 45e-3, .spring = 55e-3};
    return options;
}

/// Pivot, roller centre and spring of an arm that has turned outwards by `swing` since the lowest load.
struct World {
    const Roller& roller;

    [[nodiscard]] Vec pivot() const {
        return {roller.arm.pivot * std::cos(roller.direction), roller.arm.pivot * std::sin(roller.direction)};
    }
    [[nodiscard]] Vec centre(double swing) const {
        const FollowerArm& a = roller.arm;
        const double rim = roller.base_radius + roller.radius;
        const double at_pivot = std::acos((a.length * a.length + a.pivot * a.pivot - rim * rim) / (2.0 * a.length * a.pivot)) + swing;
        const double angle = roller.direction + core::kPi - a.side * at_pivot;
        return {pivot().x + a.length * std::cos(angle), pivot().y + a.length * std::sin(angle)};
    }
    /// Compression of the spring since then: its pin on the arm moves on a circle about the pivot, towards the other one.
    [[nodiscard]] double travel(double swing) const {
        const FollowerArm& a = roller.arm;
        const Vec seat{a.lever, a.spring}, pin{a.lever * std::cos(swing), a.lever * std::sin(swing)};  // the pivot is the origin
        return a.spring - std::hypot(seat.x - pin.x, seat.y - pin.y);
    }
};

/// The swing that a rim of points allows the turned cam's roller.
double pushed_arm(const std::vector<PathPoint>& rim, const CamOptions& options, double cam_angle) {
    const World world{options.roller};
    const double turned = -options.torque_sign * cam_angle, c = std::cos(turned), s = std::sin(turned);
    const auto clear = [&](double swing) {
        const Vec at = world.centre(swing);
        return std::all_of(rim.begin(), rim.end(), [&](const PathPoint& p) {
            return std::hypot(c * p.x() - s * p.y() - at.x, s * p.x() + c * p.y() - at.y) >= options.roller.radius;
        });
    };
    double inside = -0.3, outside = 1.2;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (inside + outside);
        (clear(middle) ? outside : inside) = middle;
    }
    return outside;
}

class RollerArm : public testing::TestWithParam<std::pair<int, int>> {};
INSTANTIATE_TEST_SUITE_P(Sides, RollerArm, testing::Values(std::pair{1, 1}, std::pair{1, -1}, std::pair{-1, 1}, std::pair{-1, -1}));

// Turn the rim and push the arm away with it: the spring has the compression of the law.
TEST_P(RollerArm, RimCompressesTheSpringAsTheLawAsks) {
    const auto [side, sign] = GetParam();
    const CamOptions options = arm_options(side, sign);
    const auto cam = synthesize_cam(parallel_arm(), options);
    ASSERT_TRUE(cam) << core::to_line(cam.refusal().front());
    std::vector<PathPoint> rim;
    constexpr double kStep = core::kTurn / 20000;
    for (int i = 0; i < 20000; ++i) rim.push_back(cam->path(cam->groove_psi.low + kStep * i));
    for (std::size_t i = 0; i < cam->working.size(); i += 57) {
        const ArmPoint& arm = cam->working[i].arm;
        // Between two points the roller sinks in, most where the rim is flat.
        const double apart = cam->working[i].path.rho * kStep, sunk = 0.125 * apart * apart / options.roller.radius;
        EXPECT_NEAR(World{options.roller}.travel(pushed_arm(rim, options, arm.angle)), arm.travel, 1e-9 + 2.0 * sunk) << arm.angle;
    }
}

// A disc beside its centre: the roller's centre is always the same distance from the disc's. Arm and slope by central differences.
TEST_P(RollerArm, TouchesAnEccentricDiscEverywhere) {
    const auto [side, sign] = GetParam();
    CamOptions options = arm_options(side, sign);
    constexpr double kRim = 35e-3, kAside = 8e-3, kFirst = 2.6;
    const World world{options.roller};
    const auto travel_at = [&](double a) {
        const double angle = kFirst - options.torque_sign * a;
        const Vec disc{kAside * std::cos(angle), kAside * std::sin(angle)};
        double inside = -0.5, outside = 1.2;
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (inside + outside);
            const Vec at = world.centre(middle);
            (std::hypot(at.x - disc.x, at.y - disc.y) > kRim + options.roller.radius ? outside : inside) = middle;
        }
        return world.travel(outside);
    };
    constexpr double kStep = 1e-4;
    for (double a = 0.1; a < 2.0; a += 0.1) {
        ArmPoint arm;
        arm.angle = a;
        arm.travel = travel_at(a);
        arm.arm = (travel_at(a + kStep) - travel_at(a - kStep)) / (2.0 * kStep);
        arm.slope = (travel_at(a + kStep) - 2.0 * arm.travel + travel_at(a - kStep)) / (kStep * kStep);
        const Contact c = touch(PartKind::kParallel, arm, options);
        const double body = c.path.psi - kFirst;
        EXPECT_NEAR(c.path.rho, kRim, 2e-7) << a;
        EXPECT_NEAR(c.path.h, kRim + kAside * std::cos(body), 1e-9) << a;
        EXPECT_NEAR(c.path.slope, -kAside * std::sin(body), 1e-9) << a;
    }
}

TEST_P(RollerArm, ClosesAndIsProvenConvex) {
    const auto [side, sign] = GetParam();
    const auto cam = synthesize_cam(parallel_arm(), arm_options(side, sign));
    ASSERT_TRUE(cam);
    const Certificate certificate = certify(*cam);
    EXPECT_EQ(certificate.convex, Proof::kProven) << certificate.open;
    EXPECT_EQ(certificate.ordered, Proof::kProven) << certificate.open;
    EXPECT_LT(certificate.seam, 1e-9);
}

// Energy: what the rim turns in is what the spring takes. The moment of the force on the rim about the axis is the law's torque.
TEST_P(RollerArm, ForceOnTheRimHasTheTorqueOfTheLaw) {
    const auto [side, sign] = GetParam();
    const CamOptions options = arm_options(side, sign);
    const ArmFunction arm = parallel_arm();
    const core::Range loads = arm.law().loads();
    for (int i = 0; i <= 10; ++i) {
        const double tau = loads.low + loads.width() * i / 10.0;
        const Contact c = touch(PartKind::kParallel, arm.at_load(tau), options);
        EXPECT_NEAR(sign * rim_force(c.arm, options) * c.path.slope, arm.law().at_load(tau).f_pe, 1e-12);
    }
}

/// An arm so long that its roller moves along the slide's line, with its spring on the roller.
CamOptions nearly_slide(double length, int side, int torque_sign) {
    CamOptions options = arm_options(side, torque_sign);
    const double rim = options.roller.base_radius + options.roller.radius;
    options.roller.arm = {.length = length, .pivot = std::hypot(length, rim), .side = side, .lever = length, .spring = length};
    options.roller.direction = core::kPi / 2.0 - side * std::atan2(length, rim);  // the roller stands at 90 deg
    return options;
}

TEST_P(RollerArm, AVeryLongArmIsASlide) {
    const auto [side, sign] = GetParam();
    CamOptions slide = arm_options(side, sign);
    slide.roller.follower = FollowerKind::kSlide;
    slide.roller.direction = core::kPi / 2.0;
    const ArmFunction arm = parallel_arm();
    const auto off = [&](double length, double tau) {
        const Contact a = touch(PartKind::kParallel, arm.at_load(tau), slide),
                      b = touch(PartKind::kParallel, arm.at_load(tau), nearly_slide(length, side, sign));
        return std::hypot(a.path.x() - b.path.x(), a.path.y() - b.path.y());
    };
    for (const double tau : {0.7, 1.2, 2.0}) {
        EXPECT_LT(off(50.0, tau), 1e-5);                                // [m]
        EXPECT_NEAR(off(5.0, tau) / off(50.0, tau), 10.0, 0.5) << tau;  // as 1/length
    }
}

TEST(RollerOnArm, CircleAboutTheAxisHasNoTorque) {
    const CamOptions options = arm_options();
    ArmPoint arm;  // no arm, no slope
    arm.tension = 100.0;
    const Contact c = touch(PartKind::kParallel, arm, options);
    EXPECT_NEAR(c.path.h, 30e-3, 1e-15);
    EXPECT_NEAR(c.path.rho, 30e-3, 1e-15);
    EXPECT_EQ(c.path.slope, 0.0);  // the moment of the rim's force
}

// The spring of 45 mm lever on a roller of 50 mm arm: at the lowest load at right angles, so that moments about the pivot give 0.9.
TEST(RollerOnArm, SpringActsThroughItsLever) {
    const CamOptions options = arm_options();
    EXPECT_NEAR(spring_ratio(ArmPoint{}, options), 0.9, 1e-12);
    ArmPoint arm;
    arm.travel = 10e-3;
    constexpr double kStep = 1e-6;
    const World world{options.roller};
    double swing = 0.0;
    while (world.travel(swing) < arm.travel) swing += kStep;
    EXPECT_NEAR(spring_ratio(arm, options), (world.travel(swing + kStep) - world.travel(swing - kStep)) / (2.0 * kStep) / 50e-3, 1e-6);
}

TEST(RollerOnArm, AWiderBaseKeepsTheAngleOfTheArm) {
    const Roller roller = arm_options().roller, wider = with_base(roller, 40e-3);
    const auto at_roller = [](const Roller& r) {
        const double rim = r.base_radius + r.radius;
        return std::acos((rim * rim + r.arm.length * r.arm.length - r.arm.pivot * r.arm.pivot) / (2.0 * rim * r.arm.length));
    };
    EXPECT_NEAR(at_roller(roller), at_roller(wider), 1e-12);
    EXPECT_EQ(with_base(roller, roller.base_radius).arm.length, wider.arm.length);
}

TEST(RollerOnArm, HollowRimIsRefusedWithABaseAndPivotThatAreFarEnough) {
    CamOptions options = arm_options();
    options.roller = with_base(options.roller, 4e-3);
    options.roller.radius = 12e-3;
    const auto refused = synthesize_cam(parallel_arm(), options);
    ASSERT_FALSE(refused);
    const core::Finding& f = refused.refusal().front();
    EXPECT_TRUE(f.rule == "cam.convexity" || f.rule == "cam.idle_arc") << f.rule;
    bool offered = false;
    for (const core::Changes& changes : f.suggestion.changes()) {
        if (changes.front().key != "k_pe.roller.base_radius_mm") continue;
        ASSERT_EQ(changes.size(), 2U) << f.suggestion.text();
        EXPECT_EQ(changes.back().key, "k_pe.roller.pivot_mm");
        options.roller.base_radius = core::m_from_mm(std::stod(changes.front().value));
        options.roller.arm.pivot = core::m_from_mm(std::stod(changes.back().value));
        offered = true;
    }
    ASSERT_TRUE(offered) << f.suggestion.text();
    EXPECT_TRUE(synthesize_cam(parallel_arm(), options));
}

TEST(RollerOnArm, AShortLeverIsRefusedWithOneThatIsLongEnough) {
    CamOptions options = arm_options();
    options.roller.arm.lever = 6e-3;
    const auto refused = synthesize_cam(parallel_arm(), options);
    ASSERT_FALSE(refused);
    const core::Finding& f = refused.refusal().front();
    EXPECT_EQ(f.rule, "cam.guide");
    ASSERT_FALSE(f.suggestion.changes().empty()) << f.suggestion.text();
    const core::Change change = f.suggestion.changes().front().front();
    EXPECT_EQ(change.key, "k_pe.roller.lever_mm");
    options.roller.arm.lever = core::m_from_mm(std::stod(change.value));
    EXPECT_TRUE(synthesize_cam(parallel_arm(), options));
}

TEST(RollerOnArm, ImpossibleArmsAreNamed) {
    const auto refused = [](auto FollowerArm::*number, double value) {
        CamOptions options = arm_options();
        options.roller.arm.*number = value;
        return field_refused([&] { return synthesize_cam(parallel_arm(), options); });
    };
    EXPECT_EQ(refused(&FollowerArm::length, 0.0), "k_pe.roller.arm_mm");
    EXPECT_EQ(refused(&FollowerArm::length, 20e-3), "k_pe.roller.pivot_mm");  // too short for the rim
    EXPECT_EQ(refused(&FollowerArm::pivot, 90e-3), "k_pe.roller.pivot_mm");
    EXPECT_EQ(refused(&FollowerArm::pivot, 10e-3), "k_pe.roller.pivot_mm");
    EXPECT_EQ(refused(&FollowerArm::lever, -1e-3), "k_pe.roller.lever_mm");
    EXPECT_EQ(refused(&FollowerArm::spring, 0.0), "k_pe.roller.spring_mm");
    spring::BaseSpring longer = compression();
    longer.free_length = 80e-3;  // 65 mm under its preload, between pins 55 mm apart
    EXPECT_EQ(field_refused([&] { return synthesize_cam(parallel_arm().on(longer), arm_options()); }), "k_pe.roller.spring_mm");
}

TEST(RollerOnArm, MirroredCamIsTheOneOfTheMirroredArm) {
    const CamOptions options = arm_options();
    const Cam reflected = mirrored(synthesize_cam(parallel_arm(), options).value());
    const Cam own = synthesize_cam(parallel_arm(), mirrored(options)).value();
    for (double psi = own.groove_psi.low; psi < own.groove_psi.high; psi += 0.3) {
        EXPECT_NEAR(reflected.path(psi).h, own.path(psi).h, 1e-9) << psi;
        EXPECT_NEAR(reflected.path(psi).slope, own.path(psi).slope, 1e-9) << psi;
    }
}

}  // namespace
}  // namespace fusee::cam
