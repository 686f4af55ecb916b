#include <algorithm>
#include <cmath>
#include <limits>

#include "fusee/cam/mirror.h"
#include "fusee/core/units.h"
#include "fusee/solid/cutters.h"
#include "fusee/solid/stack.h"

namespace fusee::solid {

namespace {

using core::mm_from_m;

constexpr int kAngles = 72;
constexpr int kFloorNormals = 360;
constexpr double kStep_mm = 0.1;
constexpr double kRingTolerance_mm = 5e-3;  // of the rings around which dowels need space
constexpr int kDirections = 36;             // of one dowel over half a turn; the other is opposite
constexpr int kSteps = 40;                  // along each, before the best one is refined
constexpr double kPlace_mm = 1e-4;          // accuracy of a dowel's place

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

double reach_of(const std::vector<Tangent>& floor) {
    double reach = 0.0;
    for (const Tangent& t : floor) reach = std::max(reach, t.away);
    return reach;
}

/// That which turns the other way: equal places are decided alike for a part and its mirror image.
Part mirror_image(const Part& part) {
    Part image;
    image.cam = cam::mirrored(part.cam), image.options = mirrored(part.options), image.z_high = part.z_high;
    return image;
}

double pins_apart(const Point2& a, const Point2& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

/// Distance from q to a closed polygon, below 0 inside.
double distance(const Ring& ring, const Point2& q) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
        const Point2 &a = ring[j], &b = ring[i];
        const double dx = b[0] - a[0], dy = b[1] - a[1], length2 = dx * dx + dy * dy;
        const double share = length2 > 0.0 ? std::clamp(((q[0] - a[0]) * dx + (q[1] - a[1]) * dy) / length2, 0.0, 1.0) : 0.0;
        nearest = std::min(nearest, std::hypot(q[0] - a[0] - share * dx, q[1] - a[1] - share * dy));
    }
    return holds(ring, q) ? -nearest : nearest;
}

/// The obstacles around dowels: bore, openings and groove floor.
class DowelSpace {
public:
    explicit DowelSpace(const Part& part) : floor_(floor_of(part)) {
        holes_.push_back(ring_of(bore_outline(part.options.hub), kRingTolerance_mm));
        for (const Cutter& cutter : top_holes(part)) holes_.push_back(ring_of(cutter.outline, kRingTolerance_mm));
    }

    /// Radius of the largest free circle around q.
    [[nodiscard]] double about(const Point2& q) const {
        double least = std::numeric_limits<double>::infinity();
        for (const auto& [x, y, away] : floor_) least = std::min(least, away - q[0] * x - q[1] * y);
        for (const Ring& hole : holes_) least = std::min(least, distance(hole, q));
        return least;
    }

    /// The best place on a ray from the axis.
    [[nodiscard]] Point2 best_along(double angle) const {
        const auto at = [&](double r) { return Point2{r * std::cos(angle), r * std::sin(angle)}; };
        const double step = reach_of(floor_) / kSteps;
        double best = step;
        for (int i = 2; i < kSteps; ++i)
            if (about(at(step * i)) > about(at(best))) best = step * i;
        double low = best - step, high = best + step;
        while (high - low > kPlace_mm) {
            const double inner = low + (high - low) / 3.0, outer = high - (high - low) / 3.0;
            if (about(at(inner)) < about(at(outer)))
                low = inner;
            else
                high = outer;
        }
        return at(0.5 * (low + high));
    }

private:
    std::vector<Tangent> floor_;
    std::vector<Ring> holes_;
};

}  // namespace

std::vector<Point2> free_for_pin(const Part& part, double pin_mm, double beside_bore_mm) {
    const double keep = 0.5 * pin_mm + kPinWall_mm;
    const std::vector<Disc> discs = obstacles(part, beside_bore_mm);
    const std::vector<Tangent> floor = floor_of(part);
    const auto is_free = [&](const Point2& p) {  // the floor is convex
        return std::all_of(floor.begin(), floor.end(), [&](const Tangent& t) { return t.away - p[0] * t.x - p[1] * t.y >= keep; }) &&
               std::all_of(discs.begin(), discs.end(), [&](const Disc& d) { return pins_apart(p, d.middle) >= d.radius + keep; });
    };
    const double reach = reach_of(floor);
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
    if (part.cam.rotation_sign < 0.0) {
        std::vector<Point2> places = pin_places(mirror_image(part), pin_mm);
        for (Point2& p : places) p[1] = -p[1];
        return places;
    }
    const std::vector<Point2> free = free_for_pin(part, pin_mm);
    const Point2* first = farthest_from({0.0, 0.0}, free);
    const Point2* second = first ? farthest_from(*first, free) : nullptr;
    if (!second || pins_apart(*first, *second) < pin_mm + 2.0 * kPinWall_mm) return {};
    return {*first, *second};
}

Dowels place_dowels(const Part& part) {
    if (part.cam.rotation_sign < 0.0) {
        Dowels dowels = place_dowels(mirror_image(part));
        for (Point2& centre : dowels.centres_mm) centre[1] = -centre[1];
        return dowels;
    }
    const DowelSpace space(part);
    Dowels best;
    best.space_mm = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < kDirections; ++i) {
        const double angle = core::kPi * i / kDirections;
        const std::array<Point2, 2> centres{space.best_along(angle), space.best_along(angle + core::kPi)};
        const double here = 2.0 * std::min(space.about(centres[0]), space.about(centres[1]));
        if (here > best.space_mm) best = {centres, here};
    }
    return best;
}

}  // namespace fusee::solid
