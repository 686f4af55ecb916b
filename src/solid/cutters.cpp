#include "fusee/solid/cutters.h"

#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"
#include "fusee/solid/mesh.h"
#include "fusee/solid/sweep.h"

namespace fusee::solid {

namespace {

constexpr double kThrough_mm = 1.0;  // cutters extend this far beyond the part: no two faces coincide

Cutter anchor(const cam::Cam& cam, double diameter_mm, double z_high_mm) {
    const cam::PathPoint path = cam.path(cam.anchor_psi);
    // The hole touches the pitch curve from inside: the cable turns from the groove's floor straight into it.
    const OutlinePoint centre = flange_point(path, -0.5 * diameter_mm, 0.0);
    const double bottom = core::mm_from_m(path.z - 0.5 * cam.options.cable_diameter);  // the cable lies in it as in the groove
    return {"anchor", circle(0.5 * diameter_mm, centre.point), bottom, z_high_mm + kThrough_mm};
}

}  // namespace

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
    std::vector<Cutter> cutters;
    if (f.anchor_hole_diameter > 0.0) cutters.push_back(anchor(part.cam, core::mm_from_m(f.anchor_hole_diameter), z_high_mm));
    if (f.leg_slot_width > 0.0)
        cutters.push_back({"leg_slot",
                           stadium(core::mm_from_m(f.leg_slot_width), core::mm_from_m(f.leg_slot_length),
                                   core::mm_from_m(f.leg_slot_radius), f.leg_slot_angle),
                           z_high_mm - core::mm_from_m(f.leg_slot_depth), z_high_mm + kThrough_mm});
    if (f.mark_width > 0.0) {
        const double rim = crossing_at_zero(upper_outline(part)), half = 0.5 * core::mm_from_m(f.mark_width), inner = 0.7 * rim;
        cutters.push_back({"mark",
                           {{{inner, -half}}, {{rim + kThrough_mm, -half}}, {{rim + kThrough_mm, half}}, {{inner, half}}},
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
