#include "fusee/solid/cutters.h"

#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"
#include "fusee/solid/fill.h"

namespace fusee::solid {

namespace {

constexpr double kThrough_mm = 1.0;  // cutters reach this far out of the part: no face of theirs lies in one of its own

/// Two half circles joined by straights, `length` overall along `angle`, about a centre at `radius` from the axis.
Ring stadium(double width, double length, double radius, double angle, double tolerance) {
    Ring ring;
    const double half = std::max(0.0, 0.5 * (length - width)), end = 0.5 * width;
    const int steps = std::max(6, static_cast<int>(std::ceil(core::kPi / (2.0 * std::acos(1.0 - std::min(0.5, tolerance / end))))));
    for (int side = 0; side < 2; ++side)
        for (int i = 0; i <= steps; ++i) {
            const double a = -core::kPi / 2.0 + core::kPi * (side + static_cast<double>(i) / steps);
            const double along = radius + (side == 0 ? half : -half) + end * std::cos(a), across = end * std::sin(a);
            ring.push_back({along * std::cos(angle) - across * std::sin(angle), along * std::sin(angle) + across * std::cos(angle)});
        }
    return ring;
}

/// Where the outline crosses the +x axis.
double rim_at_mark(const Ring& outline) {
    double rim = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
        if ((a[1] <= 0.0) == (b[1] <= 0.0)) continue;
        rim = std::max(rim, a[0] + (b[0] - a[0]) * (-a[1]) / (b[1] - a[1]));
    }
    return rim;
}

Cutter anchor(const cam::Cam& cam, double diameter_mm, const PartFrame& frame) {
    const cam::PathPoint path = cam.path(cam.anchor_psi);
    // The hole touches the pitch curve from inside, so that the cable turns from the groove's floor straight into it.
    const OutlinePoint centre = flange_point(path, -0.5 * diameter_mm, 0.0);
    const double bottom = core::mm_from_m(path.z - 0.5 * cam.options.cable_diameter);  // the cable lies in it as in the groove
    return {"anchor", circle_ring(0.5 * diameter_mm, frame.tolerance_mm, centre.point), bottom, frame.z_high_mm + kThrough_mm};
}

}  // namespace

Mesh Cutter::mesh() const {
    Mesh m = prism(ring, low_mm, high_mm);
    if (radial)  // (y, z, x) is a cyclic change of axes: orientation stays
        for (Vec3& p : m.points_mm) p = {p[2], p[0], p[1]};
    return m;
}

std::vector<Cutter> make_cutters(const cam::Cam& cam, const PartOptions& options, const PartFrame& frame) {
    const FeatureOptions& f = options.features;
    const HubOptions& hub = options.hub;
    std::vector<Cutter> cutters;
    if (f.anchor_hole_diameter > 0.0) cutters.push_back(anchor(cam, core::mm_from_m(f.anchor_hole_diameter), frame));
    if (f.leg_slot_width > 0.0)
        cutters.push_back({"leg_slot",
                           stadium(core::mm_from_m(f.leg_slot_width), core::mm_from_m(f.leg_slot_length),
                                   core::mm_from_m(f.leg_slot_radius), f.leg_slot_angle, frame.tolerance_mm),
                           frame.z_high_mm - core::mm_from_m(f.leg_slot_depth), frame.z_high_mm + kThrough_mm});
    if (f.mark_width > 0.0) {
        const double rim = rim_at_mark(frame.upper_outline), half = 0.5 * core::mm_from_m(f.mark_width), inner = 0.7 * rim;
        cutters.push_back({"mark",
                           {{inner, -half}, {rim + kThrough_mm, -half}, {rim + kThrough_mm, half}, {inner, half}},
                           frame.z_high_mm - core::mm_from_m(f.mark_depth),
                           frame.z_high_mm + kThrough_mm});
    }
    if (hub.lock == HubLock::kSetScrew) {
        const double middle = frame.z_low_mm - 0.5 * core::mm_from_m(hub.boss_height);
        cutters.push_back({"set_screw", circle_ring(0.5 * core::mm_from_m(hub.screw_diameter), frame.tolerance_mm, {0.0, middle}), 0.0,
                           0.5 * core::mm_from_m(hub.boss_diameter) + kThrough_mm, true});
    }
    return cutters;
}

}  // namespace fusee::solid
