#include <algorithm>
#include <cmath>
#include <limits>

#include "enclosure.h"
#include "fusee/cam/arm.h"
#include "fusee/cam/contact.h"
#include "fusee/math/roots.h"
#include "path.h"
#include "scan.h"

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

constexpr int kRounds = 2;  // a round divides the error by about 1/(1 - cos(fleet)), above 400 at 4 degrees

double at(const math::ChebyshevSeries& series, double angle) { return series(angle); }
math::Jet at(const math::ChebyshevSeries& series, const math::Jet& angle) {
    const math::Jet over = series.over(angle.value);
    return {over.value, over.slope * angle.slope};
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

FleetAngleCorrection::FleetAngleCorrection(double last, const Shares& shares)
    : share_({0.0, last}, shares), first_(share_.derivative()), second_(first_.derivative()) {}

template <class Arm>
void FleetAngleCorrection::project(Arm& a) const {
    const auto share = at(share_, a.angle), first = at(first_, a.angle), second = at(second_, a.angle);
    a.arm /= share;  // r = share * h, and its two derivatives
    a.slope = (a.slope - a.arm * first) / share;
    a.second_derivative = (a.second_derivative - 2.0 * a.slope * first - a.arm * second) / share;
}
template void FleetAngleCorrection::project(ArmPoint&) const;
template void FleetAngleCorrection::project(ArmJet&) const;

double fleet_of(const Contact& contact, const Guide& guide) {
    return guide.kind == GuideKind::kParallel ? 0.0 : std::atan2(guide.z - contact.path.z, contact.span);
}

std::optional<ArmFunction> in_plane(const ArmFunction& arm, const CamOptions& options, std::vector<Contact> contacts) {
    if (options.family == Family::kRoller || options.guide.kind == GuideKind::kParallel) return std::nullopt;
    const FleetAngleCorrection::Shares places = FleetAngleCorrection::places(contacts.back().arm.angle);
    ArmFunction flat = arm;
    for (int round = 0; round < kRounds; ++round) {
        if (round > 0) contacts = scan_contacts(flat, options, contacts.size());
        const Height height(options, contacts);
        FleetAngleCorrection::Shares shares{};
        for (std::size_t i = 0; i < places.size(); ++i) {
            Contact contact = contact_at(flat, options, contacts, places[i]);
            contact.path.z = height.at(contact.path.psi);
            shares[i] = std::cos(fleet_of(contact, options.guide));
        }
        if (std::all_of(shares.begin(), shares.end(), [](double share) { return share == 1.0; })) return std::nullopt;
        flat = arm.corrected_for_fleet_angle({places.back(), shares});
    }
    return flat;
}

}  // namespace fusee::cam
