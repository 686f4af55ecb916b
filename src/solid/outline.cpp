#include "fusee/solid/outline.h"

#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"

namespace fusee::solid {

namespace {

constexpr double kFireyPower = 8.0;  // at most 2^(1/8) = 9 % outside the exact hull, with a soft corner

double step_for(double radius_mm, double tolerance_mm) { return 2.0 * std::acos(1.0 - std::min(0.5, tolerance_mm / radius_mm)); }

/// Vertices of the arc from `begin` to `end`, both included.
void add_arc(Ring& ring, double radius, double begin, double end, double tolerance) {
    const int steps = std::max(3, static_cast<int>(std::ceil((end - begin) / step_for(radius, tolerance))));
    for (int i = 0; i <= steps; ++i) {
        const double angle = begin + (end - begin) * i / steps;
        ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
}

}  // namespace

Ring circle_ring(double radius_mm, double tolerance_mm, Point2 centre_mm) {
    Ring ring;
    add_arc(ring, radius_mm, 0.0, 2.0 * core::kPi, tolerance_mm);
    ring.pop_back();
    for (Point2& p : ring) p = {p[0] + centre_mm[0], p[1] + centre_mm[1]};
    return ring;
}

Ring bore_ring(const HubOptions& hub, double tolerance_mm) {
    const double radius = core::mm_from_m(0.5 * (hub.bore_diameter + hub.bore_clearance));
    Ring ring;
    if (hub.lock == HubLock::kKeyway) {
        const double half = core::mm_from_m(0.5 * hub.key_width), top = radius + core::mm_from_m(hub.key_depth);
        const double open = std::asin(half / radius);
        ring = {{top, -half}, {top, half}};
        add_arc(ring, radius, open, 2.0 * core::kPi - open, tolerance_mm);
    } else if (hub.lock == HubLock::kDFlat) {
        const double open = std::acos(1.0 - core::mm_from_m(hub.flat_depth) / radius);
        add_arc(ring, radius, open, 2.0 * core::kPi - open, tolerance_mm);
    } else {
        ring = circle_ring(radius, tolerance_mm);
    }
    return ring;
}

double bore_reach_mm(const HubOptions& hub) {
    const double radius = core::mm_from_m(0.5 * (hub.bore_diameter + hub.bore_clearance));
    if (hub.lock != HubLock::kKeyway) return radius;
    return std::hypot(radius + core::mm_from_m(hub.key_depth), core::mm_from_m(0.5 * hub.key_width));
}

OutlinePoint flange_point(const cam::PathPoint& path, double offset_mm, double core_radius_mm) {
    const double f = core::mm_from_m(path.h) + offset_mm, f1 = core::mm_from_m(path.slope);
    double h = f, h1 = f1, h2 = core::mm_from_m(path.rho - path.h);
    if (core_radius_mm > 0.0) {
        const double p = kFireyPower;
        h = std::pow(std::pow(f, p) + std::pow(core_radius_mm, p), 1.0 / p);
        const double share = std::pow(f / h, p - 1.0);  // dh/df
        h1 = share * f1;
        h2 = share * h2 + (p - 1.0) * std::pow(f / h, p - 2.0) * f1 * f1 / h * (1.0 - std::pow(f / h, p));
    }
    const double c = std::cos(path.psi), s = std::sin(path.psi);
    return {{h * c - h1 * s, h * s + h1 * c}, h + h2};
}

}  // namespace fusee::solid
