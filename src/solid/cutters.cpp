#include "fusee/solid/cutters.h"

#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"
#include "fusee/solid/mesh.h"
#include "fusee/solid/stack.h"
#include "fusee/solid/sweep.h"

namespace fusee::solid {

namespace {

constexpr double kThrough_mm = 1.0;   // cutters extend this far beyond the part: no two faces coincide
constexpr double kMarkFrom = 0.7;     // of the rim: inner end of the timing mark
constexpr double kMarkWall_mm = 0.8;  // between the mark and a hole, as the least wall of milled metal (docs/rules.md)

Cutter anchor(const cam::Cam& cam, double diameter_mm, double z_high_mm) {
    const cam::PathPoint path = cam.path(cam.anchor_psi);
    // The hole touches the pitch curve from inside: the cable turns from the groove's floor straight into it.
    const OutlinePoint centre = flange_point(path, -0.5 * diameter_mm, 0.0);
    const double bottom = core::mm_from_m(path.z - 0.5 * cam.options.cable_diameter);  // the cable lies in it as in the groove
    return {"anchor", circle(0.5 * diameter_mm, centre.point), bottom, z_high_mm + kThrough_mm};
}

Cutter leg_slot(const FeatureOptions& f, double z_high_mm) {
    return {"leg_slot",
            stadium(core::mm_from_m(f.leg_slot_width), core::mm_from_m(f.leg_slot_length), core::mm_from_m(f.leg_slot_radius),
                    f.leg_slot_angle),
            z_high_mm - core::mm_from_m(f.leg_slot_depth), z_high_mm + kThrough_mm};
}

/// Distance of the rim from the axis along +x (sign 1) or -x.
double rim_along(const Part& part, double sign) { return crossing_at_zero(upper_outline(part), sign); }

/// Do all holes of the top face keep their wall beside a mark along +x (sign 1) or -x?
bool has_room(const Part& part, double sign) {
    const double rim = rim_along(part, sign), keep = 0.5 * core::mm_from_m(part.options.features.mark_width) + kMarkWall_mm;
    for (const Cutter& hole : top_holes(part))
        for (const Point2& p : ring_of(hole.outline, 0.01)) {
            const double along = std::clamp(sign * p[0], kMarkFrom * rim, rim);
            if (std::hypot(sign * p[0] - along, p[1]) < keep) return false;
        }
    return true;
}

}  // namespace

std::vector<Cutter> top_holes(const Part& part) {
    const FeatureOptions& f = part.options.features;
    const double z_high_mm = core::mm_from_m(part.z_high);
    std::vector<Cutter> holes;
    if (f.anchor_hole_diameter > 0.0) holes.push_back(anchor(part.cam, core::mm_from_m(f.anchor_hole_diameter), z_high_mm));
    if (f.leg_slot_width > 0.0) holes.push_back(leg_slot(f, z_high_mm));
    return holes;
}

double mark_angle(const Part& part) { return has_room(part, 1.0) || !has_room(part, -1.0) ? 0.0 : core::kPi; }

Mesh Cutter::mesh(double tolerance_mm) const {
    Mesh m = prism(ring_of(outline, tolerance_mm), low_mm, high_mm);
    if (radial)  // (y, z, x) is a cyclic change of axes keeps the orientation
        for (Vec3& p : m.points_mm) p = {p[2], p[0], p[1]};
    return m;
}

std::vector<Cutter> make_cutters(const Part& part) {
    const FeatureOptions& f = part.options.features;
    const HubOptions& hub = part.options.hub;
    const double z_low_mm = core::mm_from_m(part.z_low), z_high_mm = core::mm_from_m(part.z_high);
    std::vector<Cutter> cutters = top_holes(part);
    if (is_stack(part.cam, part.options))
        if (const Dowels dowels = place_dowels(part); dowels.space_mm > kDowel_mm)
            for (const Point2& centre : dowels.centres_mm)
                cutters.push_back({"dowel", circle(0.5 * kDowel_mm, centre), z_low_mm - kThrough_mm, z_high_mm + kThrough_mm});
    if (f.mark_width > 0.0) {
        const double sign = mark_angle(part) > 0.0 ? -1.0 : 1.0, rim = rim_along(part, sign);
        const double half = sign * 0.5 * core::mm_from_m(f.mark_width), inner = sign * kMarkFrom * rim, outer = sign * (rim + kThrough_mm);
        cutters.push_back({"mark",
                           {{{inner, -half}}, {{outer, -half}}, {{outer, half}}, {{inner, half}}},
                           z_high_mm - core::mm_from_m(f.mark_depth),
                           z_high_mm + kThrough_mm});
    }
    if (hub.lock == HubLock::kSetScrew) {
        const double middle = z_low_mm - 0.5 * core::mm_from_m(hub.boss_height);
        cutters.push_back({"set_screw", circle(0.5 * core::mm_from_m(hub.screw_diameter), {0.0, middle}), 0.0,
                           0.5 * core::mm_from_m(hub.boss_diameter) + kThrough_mm, true});
    }
    return cutters;
}

}  // namespace fusee::solid
