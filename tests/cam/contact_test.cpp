#include "fusee/cam/contact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

namespace fusee::cam {
namespace {

// A disc of radius R centred at (e, 0) of the body: every contact is known by hand, and the arm of any guide follows from the centre alone.
constexpr double kDisc = 0.012, kEccentric = 0.004;

struct Case {
    const char* name;
    PartKind kind;
    Guide guide;
    int torque_sign;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

/// Distance of the cable's line from the axis when the body is turned by `turned`: the line is tangent to the disc and to the guide.
double arm_by_hand(const Case& c, double turned) {
    const double x = kEccentric * std::cos(turned), y = kEccentric * std::sin(turned);
    const double ts = c.torque_sign;
    if (c.guide.kind == GuideKind::kParallel) {
        const double n = c.guide.direction - ts * core::kPi / 2.0;
        return kDisc + x * std::cos(n) + y * std::sin(n);
    }
    // With centre distance b and radii on the same (inner) or the other side: sin(offset) = (R + sR_idler)/b between centre line and cable.
    const double gx = c.guide.distance * std::cos(c.guide.direction) - x, gy = c.guide.distance * std::sin(c.guide.direction) - y;
    const double radius = c.guide.kind == GuideKind::kIdler ? -ts * c.guide.sense * c.guide.radius : 0.0;
    const double n = std::atan2(gy, gx) - ts * std::acos((kDisc + radius) / std::hypot(gx, gy));
    return kDisc + x * std::cos(n) + y * std::sin(n);
}

class ContactOnDisc : public ::testing::TestWithParam<Case> {};

// Known: the contact must lie on the disc, whatever the guide. Five-point differences of the arm (step 1e-3) err by 1e-12 relative.
TEST_P(ContactOnDisc, LiesOnTheDisc) {
    const Case& c = GetParam();
    CamOptions options;
    options.guide = c.guide;
    options.torque_sign = c.torque_sign;
    const int sign = rotation_sign(c.kind, c.torque_sign);
    const auto arm_at = [&](double angle) { return arm_by_hand(c, sign * angle); };
    for (const double angle : {0.1, 0.9, 2.0, 3.3, 5.0}) {
        const double h = 1e-3;
        const double m2 = arm_at(angle - 2 * h), m1 = arm_at(angle - h), r0 = arm_at(angle), p1 = arm_at(angle + h),
                     p2 = arm_at(angle + 2 * h);
        ArmPoint arm;
        arm.angle = angle;
        arm.arm = r0;
        arm.slope = (m2 - 8 * m1 + 8 * p1 - p2) / (12 * h);
        arm.second_derivative = (-m2 + 16 * m1 - 30 * r0 + 16 * p1 - p2) / (12 * h * h);
        const Contact contact = touch(c.kind, arm, options);
        EXPECT_NEAR(std::hypot(contact.path.x() - kEccentric, contact.path.y()), kDisc, 1e-11) << angle;
        EXPECT_NEAR(contact.path.rho, kDisc, 1e-7) << angle;
        EXPECT_NEAR(contact.path.h, kDisc + kEccentric * std::cos(contact.path.psi), 1e-11) << angle;
        if (c.guide.kind != GuideKind::kPoint) continue;
        const double gx = c.guide.distance * std::cos(c.guide.direction - sign * angle),
                     gy = c.guide.distance * std::sin(c.guide.direction - sign * angle);
        EXPECT_NEAR(contact.span, std::hypot(gx - contact.path.x(), gy - contact.path.y()), 1e-10) << angle;
    }
}

constexpr Guide kParallelUp{GuideKind::kParallel, 1.5, 0.0, 0.0, 1, 0.0};
constexpr Guide kPointAway{GuideKind::kPoint, 0.7, 0.06, 0.0, 1, 0.0};
constexpr Guide kIdlerLeft{GuideKind::kIdler, 0.7, 0.06, 0.007, 1, 0.0};
constexpr Guide kIdlerRight{GuideKind::kIdler, 0.7, 0.06, 0.007, -1, 0.0};

INSTANTIATE_TEST_SUITE_P(Guides, ContactOnDisc,
                         ::testing::Values(Case{"spool_parallel", PartKind::kSeries, kParallelUp, 1},
                                           Case{"cam_parallel", PartKind::kParallel, kParallelUp, 1},
                                           Case{"cam_parallel_mirrored", PartKind::kParallel, kParallelUp, -1},
                                           Case{"spool_point", PartKind::kSeries, kPointAway, 1},
                                           Case{"cam_point", PartKind::kParallel, kPointAway, 1},
                                           Case{"cam_point_mirrored", PartKind::kParallel, kPointAway, -1},
                                           Case{"spool_idler_left", PartKind::kSeries, kIdlerLeft, 1},
                                           Case{"cam_idler_left", PartKind::kParallel, kIdlerLeft, 1},
                                           Case{"cam_idler_right", PartKind::kParallel, kIdlerRight, 1},
                                           Case{"cam_idler_right_mirrored", PartKind::kParallel, kIdlerRight, -1}),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(Contact, GuideInsideTheArmHasNoTangent) {
    CamOptions options;
    options.guide = {GuideKind::kPoint, 0.0, 0.01, 0.0, 1, 0.0};
    ArmPoint arm;
    arm.arm = 0.012;
    EXPECT_LT(guide_margin(PartKind::kParallel, arm, options), 0.0);
    EXPECT_TRUE(std::isnan(touch(PartKind::kParallel, arm, options).path.rho));
}

}  // namespace
}  // namespace fusee::cam
