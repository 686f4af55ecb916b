#include "fusee/solid/outline.h"

#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"
#include "fusee/solid/extrusion.h"

namespace fusee::solid {

namespace {

constexpr double kFireyPower = 8.0;  // at most 2^(1/8) = 9 % outside the exact hull, with a soft corner

double step_for(double radius_mm, double tolerance_mm) { return 2.0 * std::acos(1.0 - std::min(0.5, tolerance_mm / radius_mm)); }

}  // namespace

Point2 Arc::at(double angle) const { return {centre_mm[0] + radius_mm * std::cos(angle), centre_mm[1] + radius_mm * std::sin(angle)}; }

bool Arc::full() const { return end - begin > 2.0 * core::kPi - 1e-12; }

Outline circle(double radius_mm, Point2 centre_mm) { return {{centre_mm, radius_mm, 0.0, 2.0 * core::kPi}}; }

Outline stadium(double width_mm, double length_mm, double radius_mm, double angle) {
    Outline outline;
    for (const double side : {1.0, -1.0}) {
        const double along = radius_mm + side * std::max(0.0, 0.5 * (length_mm - width_mm));
        const double begin = angle + (side > 0.0 ? -0.5 : 0.5) * core::kPi;
        outline.push_back({{along * std::cos(angle), along * std::sin(angle)}, 0.5 * width_mm, begin, begin + core::kPi});
    }
    return outline;
}

Outline bore_outline(const HubOptions& hub) {
    const double radius = core::mm_from_m(0.5 * (hub.bore_diameter + hub.bore_clearance));
    const auto arc_from = [&](double open) { return Arc{{}, radius, open, 2.0 * core::kPi - open}; };
    if (hub.lock == HubLock::kKeyway) {
        const double half = core::mm_from_m(0.5 * hub.key_width), top = radius + core::mm_from_m(hub.key_depth);
        return {{{top, -half}}, {{top, half}}, arc_from(std::asin(half / radius))};
    }
    if (hub.lock == HubLock::kDFlat) return {arc_from(std::acos(1.0 - core::mm_from_m(hub.flat_depth) / radius))};
    return circle(radius);
}

Outline flat_shaft_outline(const HubOptions& hub) {
    HubOptions without = hub;
    without.bore_clearance = 0.0;
    return bore_outline(without);
}

double area_mm2(const Outline& outline) {  // the polygon of the arcs' ends, and the segments between arc and chord
    double twice = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Arc &arc = outline[i], &next = outline[(i + 1) % outline.size()];
        const Point2 from = arc.at(arc.begin), to = arc.at(arc.end), then = next.at(next.begin);
        twice += from[0] * to[1] - to[0] * from[1] + to[0] * then[1] - then[0] * to[1];
        twice += arc.radius_mm * arc.radius_mm * (arc.end - arc.begin - std::sin(arc.end - arc.begin));
    }
    return 0.5 * twice;
}

Outline mirrored_in_y(const Outline& outline) {
    Outline image(outline.rbegin(), outline.rend());
    for (Arc& arc : image) {
        const double turn = arc.end - arc.begin;
        arc.centre_mm[1] = -arc.centre_mm[1];
        arc.begin = arc.full() ? 0.0 : std::fmod(4.0 * core::kPi - arc.end, 2.0 * core::kPi);
        arc.end = arc.begin + turn;
    }
    return image;
}

Ring ring_of(const Outline& outline, double tolerance_mm) {
    Ring ring;
    for (const Arc& arc : outline) {
        if (arc.radius_mm == 0.0) {
            ring.push_back(arc.centre_mm);
            continue;
        }
        const double turn = arc.end - arc.begin;
        const int steps = std::max(3, static_cast<int>(std::ceil(turn / step_for(arc.radius_mm, tolerance_mm))));
        for (int i = 0; i < steps + (arc.full() ? 0 : 1); ++i) ring.push_back(arc.at(arc.begin + turn * i / steps));
    }
    return ring;
}

Ring ring_of(const Extrusion& shape, double tolerance_mm) {
    if (!shape.outline.empty()) return ring_of(shape.outline, tolerance_mm);
    if (shape.radius_mm > 0.0) return ring_of(circle(shape.radius_mm), tolerance_mm);
    const double x = shape.half_x_mm, y = shape.half_y_mm;
    return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

bool holds(const Ring& ring, const Point2& q) {
    bool inside = false;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
        const Point2 &a = ring[j], &b = ring[i];
        if ((a[1] > q[1]) != (b[1] > q[1]) && q[0] < a[0] + (b[0] - a[0]) * (q[1] - a[1]) / (b[1] - a[1])) inside = !inside;
    }
    return inside;
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
