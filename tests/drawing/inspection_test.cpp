#include "fusee/drawing/inspection.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "exchange/fixtures/parts.h"

namespace fusee::drawing {
namespace {

constexpr double kTen = 10.0 * core::kPi / 180.0;

solid::Part bare(const cam::Cam& cam) {
    solid::Part part;
    part.cam = cam;
    part.options.features.anchor_hole_diameter = 0.0;
    return part;
}

TEST(InspectFloor, OfAnEccentricDiscIsItsPolarEquation) {
    // Pitch circle of 12 mm about (2, 0), cable of 1 mm: the floor is a circle of 11.5 mm, r = e cos a + sqrt(R^2 - e^2 sin^2 a).
    const auto floor = inspect_floor(bare(fixtures::planar_cam(12e-3, 2e-3)), kTen);
    ASSERT_EQ(floor.size(), 36u);
    for (std::size_t i = 0; i < floor.size(); ++i) {
        const double a = kTen * static_cast<double>(i);
        EXPECT_NEAR(floor[i].angle, a, 1e-12);
        EXPECT_NEAR(floor[i].radius, 2e-3 * std::cos(a) + std::sqrt(11.5e-3 * 11.5e-3 - std::pow(2e-3 * std::sin(a), 2)), 1e-15);
        EXPECT_EQ(floor[i].z, 0.0);
    }
}

TEST(InspectFloor, KnowsTheWorkingArcByItsNormals) {
    const cam::Cam cam = fixtures::planar_cam();  // working arc psi 0.5 to 3.0
    // The floor's point at psi: body angle psi + atan(h'/h) with h = 11.5 + 2 cos psi.
    const auto angle = [](double psi) { return psi + std::atan2(-2.0 * std::sin(psi), 11.5 + 2.0 * std::cos(psi)); };
    const core::Range arc{angle(0.5), angle(3.0)};
    for (const FloorPoint& p : inspect_floor(bare(cam), kTen)) EXPECT_EQ(p.works, arc.holds(p.angle)) << p.angle;
}

TEST(InspectFloor, OfAHelixClimbsAndCountsOnOverItsTurns) {
    const cam::Cam cam = fixtures::helix_cam(10e-3, 0.0, 6e-3);  // a round one: r is the floor's radius and the body angle psi itself
    const auto floor = inspect_floor(bare(cam), kTen);
    ASSERT_GT(floor.size(), 50u);  // 10.2 rad
    EXPECT_NEAR(floor.front().angle, -2.0 * kTen, 1e-12);
    for (const FloorPoint& p : floor) {
        EXPECT_NEAR(p.radius, 9.5e-3, 1e-15);
        EXPECT_NEAR(p.z, 6e-3 * p.angle / (2.0 * core::kPi), 1e-15);
    }
}

TEST(InspectFloor, SaysWhereTheAnchorHoleHasTakenTheFloor) {
    solid::Part part = bare(fixtures::planar_cam(12e-3, 0.0));
    part.section = solid::groove_section({}, 1e-3, 1e-5);
    part.options.features.anchor_hole_diameter = 3e-3;
    // The hole touches the pitch circle from inside at psi 3.6: centre at 10.5 mm, its rim crosses the floor (11.5 mm) where
    // cos(da) = (11.5^2 + 10.5^2 - 1.5^2)/(2 11.5 10.5), 0.102 rad or 5.8 degrees to both sides of 206.3.
    for (const FloorPoint& p : inspect_floor(part, kTen)) EXPECT_EQ(p.drilled, std::abs(p.angle - 3.6) < 0.102) << p.angle;
}

TEST(CableLength, OfADiscIsItsArc) {
    const CableLength length = cable_length(fixtures::planar_cam(12e-3, 2e-3));
    // Chords of 1/1000 turn, corrected to the fourth order: (2 pi/1000)^4/1920 = 1e-12 of the length is left.
    EXPECT_NEAR(length.working, 12e-3 * 2.5, 1e-13);
    EXPECT_NEAR(length.to_anchor, 12e-3 * (0.5 + 2.0 * core::kPi - 3.6), 1e-13);  // the tension winds towards lower psi
}

TEST(CableLength, OfAHelixCountsItsClimb) {
    const CableLength length = cable_length(fixtures::helix_cam(10e-3, 0.0, 6e-3));
    const double per_rad = std::hypot(10e-3, 6e-3 / (2.0 * core::kPi));
    EXPECT_NEAR(length.working, 9.4 * per_rad, 1e-12);
    EXPECT_NEAR(length.to_anchor, 0.2 * per_rad, 1e-12);
}

/// Floor point of a cam at psi, straight from the support function.
std::array<double, 2> floor_at(const cam::Cam& cam, double psi) {
    const cam::PathPoint p = cam.path(psi);
    const double h = p.h - 0.5 * cam.options.cable_diameter;
    return {h * std::cos(psi) - p.slope * std::sin(psi), h * std::sin(psi) + p.slope * std::cos(psi)};
}

TEST(CheckRows, OfAnEccentricDiscAreEvenOnItsCircle) {
    // Pitch circle of 12 mm about (2, 0), cable of 1 mm: the floor is a circle of 11.5 mm about (2, 0), working arc psi 0.5 to 3.0.
    const cam::Cam cam = fixtures::planar_cam(12e-3, 2e-3);
    const auto rows = check_rows(bare(cam), 6);
    ASSERT_EQ(rows.size(), 6u);
    const bool falls = cam.rotation_sign > 0;
    for (std::size_t i = 0; i < 6; ++i) {
        const double psi = falls ? 3.0 - 0.5 * static_cast<double>(i) : 0.5 + 0.5 * static_cast<double>(i);
        EXPECT_NEAR(rows[i].normal, psi, 1e-6);
        EXPECT_NEAR(rows[i].length, 11.5e-3 * 0.5 * static_cast<double>(i), 1e-9);
        EXPECT_NEAR(rows[i].x, 2e-3 + 11.5e-3 * std::cos(psi), 1e-8);
        EXPECT_NEAR(rows[i].y, 11.5e-3 * std::sin(psi), 1e-8);
        EXPECT_NEAR(rows[i].arm, 12e-3 + 2e-3 * std::cos(psi), 1e-8);
        EXPECT_NEAR(rows[i].radius, std::hypot(rows[i].x, rows[i].y), 1e-15);
        EXPECT_NEAR(std::tan(rows[i].angle), rows[i].y / rows[i].x, 1e-9);
        // The sine rule in the triangle axis, centre, point: 11.5 sin(tilt) = 2 sin(angle).
        EXPECT_NEAR(11.5e-3 * std::sin(rows[i].tilt()), 2e-3 * std::sin(rows[i].angle), 1e-12);
    }
}

/// Against a finite difference of the floor's points, which knows no support function.
TEST(CheckRows, NormalsAreThoseOfTheCurve) {
    for (const cam::Cam& cam : {fixtures::planar_cam(8e-3, 1e-3), fixtures::helix_cam()}) {
        const auto rows = check_rows(bare(cam));
        ASSERT_EQ(rows.size(), kCheckRows);
        for (const CheckRow& row : rows) {
            const double step = 1e-5;
            const auto a = floor_at(cam, row.normal - step), b = floor_at(cam, row.normal + step);
            const double dx = b[0] - a[0], dy = b[1] - a[1], length = std::hypot(dx, dy);
            EXPECT_NEAR(dy / length, std::cos(row.normal), 1e-6);
            EXPECT_NEAR(-dx / length, std::sin(row.normal), 1e-6);
        }
        for (std::size_t i = 1; i < rows.size(); ++i) {  // even lengths, by chords
            double chord = 0.0;
            for (int k = 0; k < 200; ++k) {
                const double u = rows[i - 1].normal + (rows[i].normal - rows[i - 1].normal) * k / 200.0,
                             v = rows[i - 1].normal + (rows[i].normal - rows[i - 1].normal) * (k + 1) / 200.0;
                const auto a = floor_at(cam, u), b = floor_at(cam, v);
                chord += std::hypot(b[0] - a[0], b[1] - a[1]);
            }
            EXPECT_NEAR(chord / rows[1].length, 1.0, 1e-5);
        }
    }
}

/// The last column of the drawing: a floor moved along its normal by delta has radii greater by delta/cos(tilt) at the same angle.
TEST(CheckRows, CosineOfTheTiltIsWhatAnErrorOfTheRadiusIsWorth) {
    const cam::Cam cam = fixtures::planar_cam(12e-3, 5e-3);
    cam::Cam wider = cam;
    const double delta = 1e-7;
    wider.path = [cam, delta](double psi) {
        cam::PathPoint p = cam.path(psi);
        p.h += delta, p.rho += delta;
        return p;
    };
    for (const CheckRow& row : check_rows(bare(cam), 9)) {
        // The wider floor's radius at the row's body angle, by bisection over psi.
        double low = row.normal - 0.1, high = row.normal + 0.1;
        const auto angle = [&](double psi) {
            const auto p = floor_at(wider, psi);
            return std::remainder(std::atan2(p[1], p[0]) - row.angle, 2.0 * core::kPi);
        };
        for (int i = 0; i < 80; ++i) (angle(0.5 * (low + high)) < 0.0 ? low : high) = 0.5 * (low + high);
        const auto p = floor_at(wider, 0.5 * (low + high));
        EXPECT_NEAR(delta / (std::hypot(p[0], p[1]) - row.radius), std::cos(row.tilt()), 1e-4);
    }
}

}  // namespace
}  // namespace fusee::drawing
