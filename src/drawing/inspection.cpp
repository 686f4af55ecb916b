#include "fusee/drawing/inspection.h"

#include <algorithm>
#include <cmath>

#include "fusee/math/roots.h"
#include "fusee/solid/cutters.h"

namespace fusee::drawing {

namespace {

/// Body angle of the floor's point, continued over the turns. It rises with psi, since the floor is convex and encloses the axis.
double body_angle(const cam::PathPoint& p, double half_cable) { return p.psi + std::atan2(p.slope, p.h - half_cable); }

double psi_at(const cam::Cam& cam, double angle) {
    const double half_cable = 0.5 * cam.options.cable_diameter;
    const auto [low, high] = cam.groove_psi;
    const auto miss = [&](double psi) { return body_angle(cam.path(psi), half_cable) - angle; };
    const auto root = math::bracketed_root(miss, low, high);
    return root ? *root : std::abs(miss(low)) < std::abs(miss(high)) ? low : high;  // an end itself
}

/// The anchor hole, if there is one.
std::vector<solid::Cutter> anchor_holes(const solid::Part& part) {
    if (part.options.features.anchor_hole_diameter <= 0.0) return {};
    std::vector<solid::Cutter> cutters = solid::make_cutters(part);
    std::erase_if(cutters, [](const solid::Cutter& c) { return c.name != "anchor"; });
    return cutters;
}

bool takes(const solid::Cutter& hole, double x_mm, double y_mm, double z_mm) {
    const solid::Arc& rim = hole.outline.front();
    constexpr double kRounding_mm = 1e-9;
    return z_mm > hole.low_mm && z_mm < hole.high_mm &&
           std::hypot(x_mm - rim.centre_mm[0], y_mm - rim.centre_mm[1]) < rim.radius_mm - kRounding_mm;
}

/// Length between two directions: the chord c of an arc of angle a is shorter by the factor 1 - a^2/24.
double length_between(const cam::Cam& cam, double from, double to) {
    const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(to - from) / (1e-3 * core::kTurn))));
    const double turn = (to - from) / steps;
    double length = 0.0;
    for (int i = 0; i < steps; ++i) {
        const cam::PathPoint a = cam.path(from + turn * i), b = cam.path(from + turn * (i + 1));
        const double in_plane = std::hypot(b.x() - a.x(), b.y() - a.y()) * (1.0 + turn * turn / 24.0);
        length += std::hypot(in_plane, b.z - a.z);
    }
    return length;
}

}  // namespace

std::vector<FloorPoint> inspect_floor(const solid::Part& part, double step) {
    const cam::Cam& cam = part.cam;
    const double half_cable = 0.5 * cam.options.cable_diameter, margin = 1e-9 * step;
    const core::Range ends{body_angle(cam.path(cam.groove_psi.low), half_cable), body_angle(cam.path(cam.groove_psi.high), half_cable)};
    const std::vector<solid::Cutter> holes = anchor_holes(part);
    std::vector<FloorPoint> floor;
    const double first = std::ceil((ends.low - margin) / step), last = std::floor((ends.high + margin) / step);
    for (double i = first; i <= last; ++i) {
        const cam::PathPoint p = cam.path(psi_at(cam, i * step));
        const double h = p.h - half_cable, radius = std::hypot(h, p.slope),
                     angle = cam.closed() ? core::within_turn(i * step, -margin) : i * step;
        const double x_mm = core::mm_from_m(radius * std::cos(angle)), y_mm = core::mm_from_m(radius * std::sin(angle));
        const auto drilled = [&](const solid::Cutter& hole) { return takes(hole, x_mm, y_mm, core::mm_from_m(p.z)); };
        floor.push_back({angle, radius, p.z, cam.working_psi.holds(p.psi), std::any_of(holes.begin(), holes.end(), drilled)});
    }
    const auto before = [](const FloorPoint& a, const FloorPoint& b) { return a.angle < b.angle; };
    std::sort(floor.begin(), floor.end(), before);
    const auto same = [step](const FloorPoint& a, const FloorPoint& b) { return b.angle - a.angle < 0.5 * step; };
    floor.erase(std::unique(floor.begin(), floor.end(), same), floor.end());  // the first point of a turn is its last
    return floor;
}

CableLength cable_length(const cam::Cam& cam) {
    const auto [low, high] = cam.working_psi;
    // The tension's torque winds the cable towards lower psi if it is positive; a closed path starts with its working arc.
    const double wound = cam.options.torque_sign < 0 ? high : cam.closed() ? low + core::kTurn : low;
    return {length_between(cam, low, high), length_between(cam, wound, cam.anchor_psi)};
}

}  // namespace fusee::drawing
