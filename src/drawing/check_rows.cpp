#include <algorithm>
#include <cmath>

#include "fusee/drawing/inspection.h"

namespace fusee::drawing {

namespace {

constexpr int kSteps = 8192;  // of the arc's length: trapezoids, the relative error is below 1e-7

/// Length of the floor's arc from the first of kSteps + 1 even directions to each [m]. ds = rho dpsi of the pitch curve's parallel.
std::vector<double> lengths(const cam::Cam& cam, double from, double to) {
    const double half_cable = 0.5 * cam.options.cable_diameter;
    std::vector<double> length{0.0};
    const double step = (to - from) / kSteps;
    double before = cam.path(from).rho - half_cable;
    for (int i = 1; i <= kSteps; ++i) {
        const double rho = cam.path(from + step * i).rho - half_cable;
        length.push_back(length.back() + 0.5 * (before + rho) * std::abs(step));
        before = rho;
    }
    return length;
}

/// Cosine of the free cable's fleet angle as it leaves at psi: that of the nearest working position.
double fleet_cosine(const cam::Cam& cam, double psi) {
    const auto nearer = [psi](const cam::Contact& a, const cam::Contact& b) {
        return std::abs(a.path.psi - psi) < std::abs(b.path.psi - psi);
    };
    const auto nearest = std::min_element(cam.working.begin(), cam.working.end(), nearer);
    return nearest == cam.working.end() ? 1.0 : std::cos(nearest->fleet);
}

/// A roller's, by rising psi between the two working positions beside it.
double roller_arm(const cam::Cam& cam, double psi) {
    const auto& rows = cam.working;
    if (rows.empty()) return 0.0;
    const bool falling = rows.front().path.psi > rows.back().path.psi;
    const auto before = [falling](const cam::Contact& row, double at) { return falling ? row.path.psi > at : row.path.psi < at; };
    const auto after = std::lower_bound(rows.begin(), rows.end(), psi, before);
    if (after == rows.begin()) return rows.front().arm.arm;
    if (after == rows.end()) return rows.back().arm.arm;
    const auto& [a, b] = std::pair{*(after - 1), *after};
    return std::lerp(a.arm.arm, b.arm.arm, (psi - a.path.psi) / (b.path.psi - a.path.psi));
}

CheckRow row_at(const cam::Cam& cam, double psi, double length) {
    const cam::PathPoint p = cam.path(psi);
    const double h = p.h - 0.5 * cam.options.cable_diameter;
    CheckRow row;
    row.length = length;
    row.x = h * std::cos(psi) - p.slope * std::sin(psi);
    row.y = h * std::sin(psi) + p.slope * std::cos(psi);
    row.z = p.z;
    row.radius = std::hypot(h, p.slope);
    row.normal = psi;
    row.angle = psi + std::atan2(p.slope, h);
    row.arm = cam.has_roller() ? roller_arm(cam, psi) : p.h * fleet_cosine(cam, psi);
    return row;
}

/// The part turns under a line that stands still: its contact runs against the turn.
std::array<double, 2> ends_of(const cam::Cam& cam) {
    if (cam.rotation_sign > 0) return {cam.working_psi.high, cam.working_psi.low};
    return {cam.working_psi.low, cam.working_psi.high};
}

}  // namespace

std::array<CheckRow, 2> arc_ends(const solid::Part& part) {
    const auto [from, to] = ends_of(part.cam);
    return {row_at(part.cam, from, 0.0), row_at(part.cam, to, 0.0)};
}

std::vector<CheckRow> check_rows(const solid::Part& part, std::size_t count) {
    const cam::Cam& cam = part.cam;
    const auto [from, to] = ends_of(cam);
    const std::vector<double> length = lengths(cam, from, to);
    std::vector<CheckRow> rows;
    for (std::size_t i = 0; i < count; ++i) {
        const double at = length.back() * static_cast<double>(i) / static_cast<double>(count - 1);
        const auto next = std::clamp<std::ptrdiff_t>(std::lower_bound(length.begin(), length.end(), at) - length.begin(), 1, kSteps);
        const auto k = static_cast<std::size_t>(next);
        const double share = static_cast<double>(k - 1) + (at - length[k - 1]) / (length[k] - length[k - 1]);
        rows.push_back(row_at(cam, from + (to - from) * share / kSteps, at));
    }
    return rows;
}

double arm_error_per_turn(const cam::Cam& cam) {
    double worst = 0.0;
    for (const cam::Contact& row : cam.working) worst = std::max(worst, std::abs(row.arm.slope) / row.arm.arm);
    return worst;
}

}  // namespace fusee::drawing
