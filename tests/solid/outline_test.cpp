#include "fusee/solid/outline.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fixture.h"

namespace fusee::solid {
namespace {

double area(const Ring& ring) {
    double twice = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
        twice += a[0] * b[1] - a[1] * b[0];
    }
    return 0.5 * twice;
}

TEST(Outline, CircleStaysWithinTolerance) {
    const Ring ring = ring_of(circle(10.0, {3.0, -2.0}), 1e-3);
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
        EXPECT_NEAR(std::hypot(a[0] - 3.0, a[1] + 2.0), 10.0, 1e-12);
        EXPECT_GE(std::hypot(0.5 * (a[0] + b[0]) - 3.0, 0.5 * (a[1] + b[1]) + 2.0), 10.0 - 1e-3);
    }
}

// Known areas: the circle, the circle and a key's rectangle less their common cap, the circle less a segment. The inscribed polygon loses
// at most circumference x tolerance.
TEST(Outline, BoresHaveTheirAreas) {
    const double radius = 3.0, tolerance = 1e-4, loss = 2.0 * core::kPi * radius * tolerance;
    HubOptions hub;
    hub.bore_diameter = 6e-3;
    hub.bore_clearance = 0.0;
    hub.lock = HubLock::kPlain;
    EXPECT_NEAR(area(ring_of(bore_outline(hub), tolerance)), core::kPi * 9.0, loss);
    hub.lock = HubLock::kKeyway;  // 2 mm wide, 1 mm above the bore
    const double half_angle = std::asin(1.0 / 3.0), cap = 9.0 * half_angle - 1.0 * std::sqrt(8.0);
    EXPECT_NEAR(area(ring_of(bore_outline(hub), tolerance)), core::kPi * 9.0 + 2.0 * (4.0 - std::sqrt(8.0)) - cap, loss);
    hub.lock = HubLock::kDFlat;  // 0.5 mm deep
    const double open = std::acos(2.5 / 3.0);
    EXPECT_NEAR(area(ring_of(bore_outline(hub), tolerance)), core::kPi * 9.0 - (9.0 * open - 2.5 * 3.0 * std::sin(open)), loss);
}

// Law: the flange's support function holds both the offset contour and the boss, and stays within 2^(1/8) of the larger; its rho is h +
// h''.
TEST(Outline, AnOutlinesAreaIsThatOfItsPolygonAndItsImagesKeepIt) {
    HubOptions hub;
    for (const HubLock lock : {HubLock::kSetScrew, HubLock::kKeyway, HubLock::kDFlat}) {
        hub.lock = lock;
        const Outline bore = bore_outline(hub);
        EXPECT_NEAR(area_mm2(bore), area(ring_of(bore, 1e-6)), 1e-4);
        EXPECT_NEAR(area(ring_of(mirrored_in_y(bore), 1e-6)), area_mm2(bore), 1e-4) << "counter-clockwise, too";
    }
    const Outline slot = stadium(2.0, 6.0, 5.0, 0.5), image = mirrored_in_y(slot);
    EXPECT_NEAR(area_mm2(image), area_mm2(slot), 1e-9);
    const Ring one = ring_of(slot, 1e-3), other = ring_of(image, 1e-3);
    const auto low = [](const Ring& ring) {
        return *std::min_element(ring.begin(), ring.end(), [](const Point2& a, const Point2& b) { return a[1] < b[1]; });
    };
    const auto high = [](const Ring& ring) {
        return *std::max_element(ring.begin(), ring.end(), [](const Point2& a, const Point2& b) { return a[1] < b[1]; });
    };
    EXPECT_NEAR(low(other)[1], -high(one)[1], 2e-3);
    EXPECT_NEAR(low(other)[0], high(one)[0], 0.1);
}

TEST(Outline, FlangeHoldsContourAndBoss) {
    const cam::Cam cam = test::disc(0.010, 0.007);
    for (double psi = 0.0; psi < 6.28; psi += 0.1) {
        const auto support = [&](double at) {
            const OutlinePoint p = flange_point(cam.path(at), 1.0, 8.0);
            return p.point[0] * std::cos(at) + p.point[1] * std::sin(at);
        };
        const double h = support(psi), larger = std::max(10.0 + 7.0 * std::cos(psi) + 1.0, 8.0);
        EXPECT_GE(h, larger) << psi;
        EXPECT_LE(h, larger * std::pow(2.0, 0.125)) << psi;
        const double step = 1e-4, second = (support(psi + step) - 2.0 * h + support(psi - step)) / (step * step);
        EXPECT_NEAR(flange_point(cam.path(psi), 1.0, 8.0).rho, h + second, 1e-4) << psi;
        EXPECT_GT(flange_point(cam.path(psi), 1.0, 8.0).rho, 0.0) << psi;
    }
}

}  // namespace
}  // namespace fusee::solid
