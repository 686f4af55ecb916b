#include "fusee/solid/cutters.h"

#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"
#include "fusee/solid/stack.h"
#include "fusee/solid/sweep.h"

namespace fusee::solid {

namespace {

constexpr double kThrough_mm = 1.0;   // cutters extend this far beyond the part: no two faces coincide
constexpr double kMarkFrom = 0.7;     // of the rim: inner end of the timing mark
constexpr double kMarkWall_mm = 0.8;  // between the mark and a hole, as the least wall of milled metal (docs/rules.md)

/// The hole touches the pitch curve from inside: the cable turns from the groove's floor straight into it.
Point2 anchor_centre(const cam::Cam& cam, const FeatureOptions& features) {
    return flange_point(cam.path(cam.anchor_psi), -0.5 * core::mm_from_m(features.anchor_hole_diameter), 0.0).point;
}

Cutter anchor(const Part& part) {
    const cam::Cam& cam = part.cam;
    const FeatureOptions& f = part.options.features;
    const double z = cam.path(cam.anchor_psi).z, half = 0.5 * cam.options.cable_diameter;  // the cable lies in it as in the groove
    Cutter hole{"anchor", circle(0.5 * core::mm_from_m(f.anchor_hole_diameter), anchor_centre(cam, f)), core::mm_from_m(z - half),
                core::mm_from_m(part.z_high) + kThrough_mm};
    if (anchor_leads_down(cam, part.options))
        hole.low_mm = core::mm_from_m(part.z_low) - kThrough_mm, hole.high_mm = core::mm_from_m(z + half);
    return hole;
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

bool anchor_leads_down(const cam::Cam& cam, const PartOptions& options) {
    if (cam.closed() || !cam.path || options.features.anchor_hole_diameter <= 0.0 || options.hub.kind != HubKind::kOverhung) return false;
    const auto [low, high] = cam.groove_psi;
    if (cam.path(cam.anchor_psi).z >= 0.5 * (cam.path(low).z + cam.path(high).z)) return false;
    const Point2 centre = anchor_centre(cam, options.features);
    return core::m_from_mm(std::hypot(centre[0], centre[1])) > 0.5 * (options.hub.boss_diameter + options.features.anchor_hole_diameter);
}

std::vector<Cutter> top_holes(const Part& part) {
    const FeatureOptions& f = part.options.features;
    std::vector<Cutter> holes;
    if (f.anchor_hole_diameter > 0.0 && !anchor_leads_down(part.cam, part.options)) holes.push_back(anchor(part));
    if (f.leg_slot_width > 0.0) holes.push_back(leg_slot(f, core::mm_from_m(part.z_high)));
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
    if (anchor_leads_down(part.cam, part.options)) cutters.push_back(anchor(part));
    const auto add_dowels = [&](double pin_mm, const auto& centres) {
        for (const Point2& centre : centres)
            cutters.push_back({"dowel", circle(0.5 * pin_mm, centre), z_low_mm - kThrough_mm, z_high_mm + kThrough_mm});
    };
    if (is_stack(part.cam, part.options))
        if (const Dowels dowels = place_dowels(part); dowels.space_mm > kDowel_mm) add_dowels(kDowel_mm, dowels.centres_mm);
    const double pin_mm = core::mm_from_m(part.options.dowel_diameter);
    add_dowels(pin_mm, pin_places(part, pin_mm));
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
