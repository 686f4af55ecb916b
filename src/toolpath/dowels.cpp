#include "dowels.h"

#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"

namespace fusee::toolpath {

namespace {

using core::kTurn;
using core::mm_from_m;
using solid::Point2;

constexpr double kWall_mm = 0.8;    // between a pin and any other surface: the least wall of milled metal (docs/rules.md)
constexpr double kReamed_mm = 0.1;  // allowance of the drill below the reamer, in diameter
constexpr double kPeck_mm = 1.0;    // one descent of the drill
constexpr int kAngles = 72;
constexpr double kStep_mm = 0.1;

/// A disc that pins keep off.
struct Disc {
    Point2 middle;
    double radius;
};

std::vector<Disc> obstacles(const solid::Part& part) {
    const solid::HubOptions& hub = part.options.hub;
    const solid::FeatureOptions& features = part.options.features;
    std::vector<Disc> all;
    const double bore = 0.5 * mm_from_m(hub.bore_diameter + hub.bore_clearance);
    if (hub.kind == solid::HubKind::kThrough) all.push_back({{0.0, 0.0}, bore});
    if (hub.lock == solid::HubLock::kKeyway)
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

/// Distance inside the floor: the least over all normals, since the ring is convex.
double depth_inside(const std::vector<solid::Arc>& floor, const Point2& p) {
    double depth = 1e9;
    for (const solid::Arc& arc : floor) {
        const Point2 q = arc.at(arc.begin), n{std::cos(arc.begin), std::sin(arc.begin)};
        depth = std::min(depth, (q[0] - p[0]) * n[0] + (q[1] - p[1]) * n[1]);
    }
    return depth;
}

double apart(const Point2& a, const Point2& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

const Point2* farthest(const std::vector<Point2>& places, const Point2& from) {
    const auto found =
        std::max_element(places.begin(), places.end(), [&](const Point2& a, const Point2& b) { return apart(a, from) < apart(b, from); });
    return found == places.end() ? nullptr : &*found;
}

core::Finding no_place(const solid::Part& part, double pin) {
    core::Finding f;
    f.rule = "toolpath.dowels";
    f.what = "no two dowel pins fit between bore and groove: the half plates are registered by shaft and key only";
    f.measured = 0.0;
    f.bound = core::Bound::kAtLeast;
    f.allowed = 2.0;
    f.unit = "pins";
    f.where = to_string(part.cam.kind);
    f.suggestion = core::change("machining.dowel_diameter_mm", fmt::format("{:.1f}", pin > 1.5 ? pin - 0.5 : 0.8))
                       .or_else(core::change(fmt::format("machining.{}", to_string(part.cam.kind)), core::quoted("wrap")));
    f.source = "docs/guides/milling.md: dowels, walls of 0.8 mm";
    return core::judged(f, core::Severity::kWarning);
}

void sink(Gcode& code, const Cutting& cutting, const Point2& at, double depth, double peck, double feed) {
    code.line("G0 X{:.5f} Y{:.5f}", at[0], at[1]);
    const int count = std::max(1, static_cast<int>(std::ceil(depth / peck - 1e-9)));
    for (int i = 1; i <= count; ++i) {
        code.line("G1 Z{:.5f} F{:.5f}", -depth * i / count, feed);
        code.line("G1 Z{:.5f}", i < count ? 0.5 : cutting.safe);
    }
}

}  // namespace

std::vector<Point2> dowel_places(const solid::Part& part, const Settings& settings, const std::vector<solid::Arc>& floor) {
    const double keep = 0.5 * mm_from_m(settings.dowel_diameter) + kWall_mm;
    const auto discs = obstacles(part);
    std::vector<Point2> free;
    double reach = 0.0;
    for (const solid::Arc& arc : floor) reach = std::max(reach, std::hypot(arc.at(arc.begin)[0], arc.at(arc.begin)[1]));
    for (int i = 0; i < kAngles; ++i)
        for (double r = 0.0; r < reach; r += kStep_mm) {
            const Point2 p{r * std::cos(kTurn * i / kAngles), r * std::sin(kTurn * i / kAngles)};
            if (depth_inside(floor, p) >= keep &&
                std::all_of(discs.begin(), discs.end(), [&](const Disc& d) { return apart(p, d.middle) >= d.radius + keep; }))
                free.push_back(p);
        }
    const Point2* first = farthest(free, {0.0, 0.0});
    const Point2* second = first ? farthest(free, *first) : nullptr;
    if (!second || apart(*first, *second) < 2.0 * keep) return {};
    return {*first, *second};
}

core::Findings bore_dowels(Gcode& code, const solid::Part& part, const Settings& settings, const std::vector<Plate>& plates, double pitch) {
    const double pin = mm_from_m(settings.dowel_diameter);
    if (pin <= 0.0) {
        code.comment("no dowels: half plates are registered by shaft and key");
        return {};
    }
    const auto places = dowel_places(part, settings, plates.front().walls.front().ring);
    if (places.empty()) return {no_place(part, pin)};
    code.comment("dowels: two pins ISO 8734 - {:g} m6 x {:.0f}, holes {:g} H7; body places {:.3f} {:.3f} and {:.3f} {:.3f}", pin,
                 std::floor(plates[0].thickness + plates[1].thickness), pin, places[0][0], places[0][1], places[1][0], places[1][1]);
    const Cutting cutting(settings);
    for (const bool reams : {false, true}) {
        const double diameter = reams ? pin : pin - kReamed_mm;
        code.tool(reams ? 3 : 2, fmt::format("{} {:g} mm{}", reams ? "reamer" : "drill", diameter, reams ? " H7" : ""),
                  fmt::format("end {:.5f}", diameter), mm_from_m(settings.flute_length), diameter,
                  reams ? 0.1 * settings.spindle_rpm : 0.4 * settings.spindle_rpm, settings);
        code.line("G0 Z{:.5f}", cutting.safe);
        for (std::size_t i = 0; i < plates.size(); ++i)
            for (const Point2& p : places)
                sink(code, cutting, {p[0] + pitch * static_cast<double>(i), plates[i].turned_over ? -p[1] : p[1]},
                     plates[i].thickness + cutting.breakthrough, reams ? 1e9 : kPeck_mm, 0.5 * cutting.plunge);
    }
    return {};
}

}  // namespace fusee::toolpath
