#include "shape.h"

#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"

namespace fusee::checks {

namespace {

constexpr double kStep = core::kPi / 180.0;  // [rad] between samples where no cable works

void sample(const cam::Cam& cam, double low, double high, std::vector<cam::PathPoint>& to) {
    if (!cam.path || high - low < 1e-9) return;
    const int steps = std::max(2, static_cast<int>(std::ceil((high - low) / kStep)));
    for (int i = 0; i <= steps; ++i) to.push_back(cam.path(low + (high - low) * i / steps));
}

double height_at(const std::vector<cam::PathPoint>& path, double psi) {
    const auto after = std::upper_bound(path.begin() + 1, path.end() - 1, psi, [](double v, const cam::PathPoint& p) { return v < p.psi; });
    const cam::PathPoint &a = *(after - 1), &b = *after;
    return b.psi > a.psi ? a.z + (b.z - a.z) * (psi - a.psi) / (b.psi - a.psi) : a.z;
}

}  // namespace

std::vector<cam::PathPoint> contour(const cam::Cam& cam) {
    std::vector<cam::PathPoint> points;
    for (const cam::Contact& c : cam.working) points.push_back(c.path);
    if (points.empty()) return points;
    if (points.front().psi > points.back().psi) std::reverse(points.begin(), points.end());
    std::vector<cam::PathPoint> whole;
    sample(cam, cam.groove_psi.low, points.front().psi, whole);
    const double high = points.back().psi;
    whole.insert(whole.end(), points.begin(), points.end());
    sample(cam, high, cam.groove_psi.high, whole);
    return whole;
}

const cam::Contact& worst_contact(const cam::Cam& cam, const std::function<double(const cam::Contact&)>& badness) {
    const cam::Contact* worst = &cam.working.front();
    double largest = badness(*worst);
    for (const cam::Contact& c : cam.working)
        if (const double here = badness(c); !std::isnan(largest) && !(here <= largest)) worst = &c, largest = here;
    return *worst;
}

Nearest distance_inside(const std::vector<cam::PathPoint>& path, double offset, Vec2 q) {
    Nearest nearest;
    bool first = true;
    for (const cam::PathPoint& p : path) {
        const double distance = p.h + offset - q[0] * std::cos(p.psi) - q[1] * std::sin(p.psi);
        if (first || distance < nearest.distance) nearest = {distance, p};
        first = false;
    }
    return nearest;
}

double bore_radius(const solid::HubOptions& hub) { return 0.5 * (hub.bore_diameter + hub.bore_clearance); }

std::vector<Vec2> key_corners(const solid::HubOptions& hub) {
    if (hub.lock != solid::HubLock::kKeyway) return {};
    const double top = bore_radius(hub) + hub.key_depth;
    return {{top, 0.5 * hub.key_width}, {top, -0.5 * hub.key_width}};
}

double distance_to_bore(const solid::HubOptions& hub, Vec2 q) {
    double distance = std::hypot(q[0], q[1]) - bore_radius(hub);
    if (hub.lock == solid::HubLock::kKeyway)
        distance = std::min(distance, std::hypot(std::max({-q[0], 0.0, q[0] - bore_radius(hub) - hub.key_depth}),
                                                 std::max(std::abs(q[1]) - 0.5 * hub.key_width, 0.0)));
    return distance;
}

double Slot::distance(Vec2 q) const {
    const double dx = outer[0] - inner[0], dy = outer[1] - inner[1], length2 = dx * dx + dy * dy;
    const double along = length2 > 0.0 ? std::clamp(((q[0] - inner[0]) * dx + (q[1] - inner[1]) * dy) / length2, 0.0, 1.0) : 0.0;
    return std::hypot(q[0] - inner[0] - along * dx, q[1] - inner[1] - along * dy) - radius;
}

bool has_slot(const solid::FeatureOptions& features) { return features.leg_slot_width > 0.0; }

Slot leg_slot(const solid::FeatureOptions& f) {
    const double half = std::max(0.0, 0.5 * (f.leg_slot_length - f.leg_slot_width)), c = std::cos(f.leg_slot_angle),
                 s = std::sin(f.leg_slot_angle);
    const double low = f.leg_slot_radius - half, high = f.leg_slot_radius + half;
    return {{low * c, low * s}, {high * c, high * s}, 0.5 * f.leg_slot_width};
}

double groove_width(const solid::Part& part) {
    const auto [low, high] =
        std::minmax_element(part.section.begin(), part.section.end(), [](const auto& a, const auto& b) { return a.z_mm < b.z_mm; });
    return core::m_from_mm(high->z_mm - low->z_mm);
}

double lip_offset(const solid::Part& part) {
    const auto lip =
        std::max_element(part.section.begin(), part.section.end(), [](const auto& a, const auto& b) { return a.offset_mm < b.offset_mm; });
    return core::m_from_mm(lip->offset_mm);
}

Pitch least_pitch(const cam::Cam& cam) {
    Pitch pitch;
    if (cam.closed()) return pitch;
    const std::vector<cam::PathPoint> path = contour(cam);
    for (const cam::PathPoint& p : path) {
        const double next = p.psi + 2.0 * core::kPi;
        if (next > path.back().psi) break;
        const double height = std::abs(height_at(path, next) - p.z);
        if (!pitch.turns || height < pitch.least) pitch = {true, height, p};
    }
    return pitch;
}

}  // namespace fusee::checks
