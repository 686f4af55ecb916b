#include <algorithm>
#include <cmath>

#include "fusee/cam/mirror.h"
#include "fusee/core/units.h"
#include "fusee/solid/cutters.h"

namespace fusee::solid {

namespace {

using core::mm_from_m;

constexpr int kAngles = 72;
constexpr int kFloorNormals = 360;
constexpr double kStep_mm = 0.1;

/// A disc that pins keep off.
struct Disc {
    Point2 middle;
    double radius;
};

std::vector<Disc> obstacles(const Part& part, double beside_bore_mm) {
    const HubOptions& hub = part.options.hub;
    const FeatureOptions& features = part.options.features;
    const double bore = 0.5 * mm_from_m(hub.bore_diameter + hub.bore_clearance);
    std::vector<Disc> all{{{0.0, 0.0}, bore + beside_bore_mm}};
    if (hub.lock == HubLock::kKeyway)
        all.push_back({{bore + 0.5 * mm_from_m(hub.key_depth), 0.0}, 0.5 * mm_from_m(std::hypot(hub.key_width, hub.key_depth))});
    if (features.anchor_hole_diameter > 0.0) {
        const cam::PathPoint p = part.cam.path(core::within_turn(part.cam.anchor_psi, part.cam.groove_psi.low));
        const double half = 0.5 * part.cam.options.cable_diameter;
        all.push_back({{mm_from_m(p.x() - half * std::cos(p.psi)), mm_from_m(p.y() - half * std::sin(p.psi))},
                       0.5 * mm_from_m(features.anchor_hole_diameter)});
    }
    if (features.leg_slot_width > 0.0)
        for (int i = -2; i <= 2; ++i) {
            const double r = mm_from_m(features.leg_slot_radius + 0.25 * i * (features.leg_slot_length - features.leg_slot_width));
            all.push_back(
                {{r * std::cos(features.leg_slot_angle), r * std::sin(features.leg_slot_angle)}, 0.5 * mm_from_m(features.leg_slot_width)});
        }
    return all;
}

/// A tangent of the groove's floor: its normal, and how far it is from the axis.
struct Tangent {
    double x, y, away;
};

std::vector<Tangent> floor_of(const Part& part) {
    const double half_cable = mm_from_m(0.5 * part.cam.options.cable_diameter);
    std::vector<Tangent> floor;
    for (int i = 0; i < kFloorNormals; ++i) {
        const double psi = part.cam.groove_psi.low + core::kTurn * i / kFloorNormals;
        floor.push_back({std::cos(psi), std::sin(psi), mm_from_m(part.cam.path(psi).h) - half_cable});
    }
    return floor;
}

double pins_apart(const Point2& a, const Point2& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

}  // namespace

std::vector<Point2> free_for_pin(const Part& part, double pin_mm, double beside_bore_mm) {
    const double keep = 0.5 * pin_mm + kPinWall_mm;
    const std::vector<Disc> discs = obstacles(part, beside_bore_mm);
    const std::vector<Tangent> floor = floor_of(part);
    const auto is_free = [&](const Point2& p) {  // the floor is convex
        return std::all_of(floor.begin(), floor.end(), [&](const Tangent& t) { return t.away - p[0] * t.x - p[1] * t.y >= keep; }) &&
               std::all_of(discs.begin(), discs.end(), [&](const Disc& d) { return pins_apart(p, d.middle) >= d.radius + keep; });
    };
    double reach = 0.0;
    for (const Tangent& t : floor) reach = std::max(reach, t.away);
    std::vector<Point2> free;
    for (int i = 0; i < kAngles; ++i)
        for (double r = 0.0; r < reach; r += kStep_mm)
            if (const Point2 p{r * std::cos(core::kTurn * i / kAngles), r * std::sin(core::kTurn * i / kAngles)}; is_free(p))
                free.push_back(p);
    return free;
}

const Point2* farthest_from(const Point2& from, const std::vector<Point2>& places) {
    const auto found = std::max_element(places.begin(), places.end(),
                                        [&](const Point2& a, const Point2& b) { return pins_apart(a, from) < pins_apart(b, from); });
    return found == places.end() ? nullptr : &*found;
}

std::vector<Point2> pin_places(const Part& part, double pin_mm) {
    if (pin_mm <= 0.0 || !part.cam.closed() || part.cam.has_roller()) return {};
    if (part.cam.rotation_sign < 0.0) {  // equal places are decided alike for a part and its mirror image
        Part image;
        image.cam = cam::mirrored(part.cam), image.options = mirrored(part.options);
        std::vector<Point2> places = pin_places(image, pin_mm);
        for (Point2& p : places) p[1] = -p[1];
        return places;
    }
    const std::vector<Point2> free = free_for_pin(part, pin_mm);
    const Point2* first = farthest_from({0.0, 0.0}, free);
    const Point2* second = first ? farthest_from(*first, free) : nullptr;
    if (!second || pins_apart(*first, *second) < pin_mm + 2.0 * kPinWall_mm) return {};
    return {*first, *second};
}

}  // namespace fusee::solid
