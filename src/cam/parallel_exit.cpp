#include <algorithm>
#include <cmath>
#include <limits>

#include "fusee/cam/contact.h"
#include "fusee/math/roots.h"

namespace fusee::cam {

namespace {

constexpr double kMostTurn = 1.5;       // [rad]: a cable turned by 90 deg would lead past the cam
constexpr double kOffTangent = 1e-9;    // [m]: a hole within the contour has no tangent
constexpr double kDistanceStep = 1e-3;  // relative

struct Hole {
    double x = 0.0, y = 0.0;  ///< [m], world
};

/// The hole at this distance on the line of the cable with the mean of the least and the largest arm.
Hole hole_at(const Cam& cam, double distance) {
    const auto [least, largest] =
        std::minmax_element(cam.working.begin(), cam.working.end(), [](const Contact& a, const Contact& b) { return a.path.h < b.path.h; });
    const double mean = 0.5 * (least->path.h + largest->path.h), along = std::sqrt(distance * distance - mean * mean);
    const double cable = cam.options.guide.direction, normal = cable - cam.options.torque_sign * core::kPi / 2.0;
    return {mean * std::cos(normal) + along * std::cos(cable), mean * std::sin(normal) + along * std::sin(cable)};
}

/// The arm of the cable from the hole at this working position [m]; NaN: none.
double arm_to(const Hole& hole, const Cam& cam, const Contact& contact) {
    const double turned = cam.rotation_sign * contact.arm.angle, side = cam.options.torque_sign;
    const auto off_tangent = [&](double psi) {
        const PathPoint p = cam.path(psi);
        const double c = std::cos(psi + turned), s = std::sin(psi + turned);
        return math::Tangent{side * (hole.x * c + hole.y * s - p.h), side * (hole.y * c - hole.x * s - p.slope)};
    };
    const double start = contact.path.psi;
    const double psi = math::rising_root(off_tangent, start - kMostTurn, start + kMostTurn, start);
    return std::abs(off_tangent(psi).value) < kOffTangent ? cam.path(psi).h : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

ExitError parallel_exit_error(const Cam& cam, double distance) {
    const Hole hole = hole_at(cam, distance);
    ExitError worst;
    for (std::size_t row = 0; row < cam.working.size(); ++row) {
        const Contact& contact = cam.working[row];
        const double error = std::abs(arm_to(hole, cam, contact) / contact.path.h - 1.0);
        if (!(error <= worst.relative)) worst = {error, row};
        if (std::isnan(error)) break;
    }
    return worst;
}

double least_parallel_distance(const Cam& cam, double relative, const core::Range& distance) {
    double low = distance.low, high = distance.high;
    const auto suffices = [&](double at) { return parallel_exit_error(cam, at).relative <= relative; };
    if (suffices(low)) return low;
    if (!suffices(high)) return high;
    while (high > low * (1.0 + kDistanceStep)) {
        const double middle = std::sqrt(low * high);
        (suffices(middle) ? high : low) = middle;
    }
    return high;
}

}  // namespace fusee::cam
