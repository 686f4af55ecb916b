#include "shape.h"

#include <algorithm>
#include <cmath>

#include "fusee/core/lists.h"
#include "fusee/core/units.h"

namespace fusee::checks {

namespace {

constexpr double kShortest = 1e-3;           // [mm]: shorter faces of the section are rounding errors
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
    auto points = core::each<cam::PathPoint>(cam.working, &cam::Contact::path);
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

double hub_radius(const solid::HubOptions& hub) {
    double reach = bore_radius(hub);
    for (const Vec2& corner : key_corners(hub)) reach = std::max(reach, std::hypot(corner[0], corner[1]));
    return reach;
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

std::vector<Hole> holes(const solid::Part& part) {
    const solid::HubOptions& hub = part.options.hub;
    std::vector<Hole> all{{2.0 * bore_radius(hub), bore_length(part), "bore", "hub.bore_mm"}};
    if (part.options.features.anchor_hole_diameter > 0.0)
        all.push_back(
            {part.options.features.anchor_hole_diameter, 0.5 * (part.z_high - part.z_low), "anchor hole", "features.anchor_hole_mm"});
    if (hub.lock == solid::HubLock::kSetScrew && hub.screw_diameter > 0.0)
        all.push_back({hub.screw_diameter, 0.5 * (hub.boss_diameter - hub.bore_diameter), "set screw's hole", "hub.screw_mm"});
    return all;
}

Hole slenderest_hole(const solid::Part& part) {
    const std::vector<Hole> all = holes(part);
    return *std::max_element(all.begin(), all.end(),
                             [](const Hole& a, const Hole& b) { return a.depth / a.diameter < b.depth / b.diameter; });
}

Hole smallest_hole(const solid::Part& part) {
    const std::vector<Hole> all = holes(part);
    return *std::min_element(all.begin(), all.end(), [](const Hole& a, const Hole& b) { return a.diameter < b.diameter; });
}

double bore_length(const solid::Part& part) {
    const solid::HubOptions& hub = part.options.hub;
    if (hub.kind == solid::HubKind::kThrough) return part.z_high - part.z_low + hub.boss_height;
    return std::max(0.0, hub.boss_height + part.options.groove.rib - hub.web);
}

double swept_radius(const solid::Part& part, const cam::PathPoint& p) {
    const double lip = part.section.empty() ? 0.0 : lip_offset(part);
    return std::hypot(p.h + lip + part.options.flange_height, p.slope);
}

const cam::PathPoint& farthest(const solid::Part& part, const std::vector<cam::PathPoint>& path) {
    return *std::max_element(path.begin(), path.end(),
                             [&](const auto& a, const auto& b) { return swept_radius(part, a) < swept_radius(part, b); });
}

std::optional<AnchorHole> anchor_hole(const solid::Part& part) {
    const double radius = 0.5 * part.options.features.anchor_hole_diameter;
    if (radius <= 0.0 || !part.cam.path || part.cam.working.empty()) return std::nullopt;
    const cam::PathPoint at = part.cam.path(part.cam.anchor_psi);
    const double c = std::cos(at.psi), s = std::sin(at.psi), h = at.h - radius;
    return AnchorHole{{h * c - at.slope * s, h * s + at.slope * c}, radius, at};
}

double wound_angle(const cam::Cam& cam, const cam::Contact& contact) {
    const double sign = cam.options.torque_sign, end = sign > 0 ? cam.working_psi.low : cam.working_psi.high;
    const double beyond = std::fmod(sign * (end - cam.anchor_psi) + 4.0 * core::kPi, 2.0 * core::kPi);  // a planar anchor is one turn away
    return beyond + sign * (contact.path.psi - end);
}

double groove_slope(const cam::Cam& cam, const cam::Contact& c) {
    const cam::Contact &first = cam.working.front(), &last = cam.working.back();
    const cam::PathPoint &before = (&c == &first ? &c : &c - 1)->path, &after = (&c == &last ? &c : &c + 1)->path;
    return cam.options.torque_sign * (after.z - before.z) / ((after.psi - before.psi) * c.path.rho);
}

double fleet_from_groove(const cam::Cam& cam, const cam::Contact& c) {
    const bool aimed = !cam.closed() && cam.options.path.lead == cam::Lead::kAimedAtGuide && cam.working.size() > 1;
    return aimed ? c.fleet - std::atan(groove_slope(cam, c)) : c.fleet;
}

double largest_torque(const cam::Cam& cam) {
    const auto torque = [](const cam::Contact& c) { return c.arm.tension * std::abs(c.arm.arm); };
    return torque(worst_contact(cam, torque));
}

double largest_overhang(const solid::Part& part) {
    double largest = 0.0;
    for (std::size_t i = 1; i < part.section.size(); ++i) {  // from the lower to the upper lip
        const solid::SectionPoint &a = part.section[i - 1], &b = part.section[i];
        const double out = b.offset_mm - a.offset_mm, rise = b.z_mm - a.z_mm;
        if (out > 0.0 && std::hypot(out, rise) > kShortest) largest = std::max(largest, std::atan2(out, rise));
    }
    return largest;
}

double half_width_at_cable(const solid::Part& part) {
    for (std::size_t i = part.section.size() / 2 + 1; i < part.section.size(); ++i) {  // outwards along the upper half
        const solid::SectionPoint &a = part.section[i - 1], &b = part.section[i];
        if (b.offset_mm < 0.0) continue;
        const double share = b.offset_mm > a.offset_mm ? -a.offset_mm / (b.offset_mm - a.offset_mm) : 0.0;
        return core::m_from_mm(a.z_mm + share * (b.z_mm - a.z_mm));
    }
    return 0.5 * groove_width(part);
}

std::optional<double> guide_gap(const solid::Part& part) {
    const cam::Guide& guide = part.cam.options.guide;
    const std::vector<cam::PathPoint> path = contour(part.cam);
    if (guide.kind == cam::GuideKind::kParallel || guide.distance <= 0.0 || path.empty()) return std::nullopt;
    const double idler = guide.kind == cam::GuideKind::kIdler ? guide.radius : 0.0;
    return guide.distance - idler - 0.5 * part.cam.options.cable_diameter - swept_radius(part, farthest(part, path));
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
