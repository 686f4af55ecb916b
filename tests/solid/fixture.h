#pragma once
#include <cmath>

#include "fusee/cam/cam.h"
#include "fusee/solid/part.h"

namespace fusee::solid::test {

/// A planar disc of radius `radius` centred at (eccentric, 0): h = R + e cos psi. Contacts are known by hand. [m]
inline cam::Cam disc(double radius = 0.012, double eccentric = 0.0, double cable = 0.8e-3) {
    cam::Cam cam;
    cam.kind = cam::PartKind::kSeries;
    cam.options.cable_diameter = cable;
    cam.working_psi = {0.0, 4.0};
    cam.groove_psi = {0.0, 2.0 * core::kPi};
    cam.anchor_psi = 5.6;
    cam.path = [radius, eccentric](double psi) {
        return cam::PathPoint{psi, radius + eccentric * std::cos(psi), -eccentric * std::sin(psi), radius, 0.0};
    };
    return cam;
}

/// A snail over `turns` turns of working arc: h grows by `growth` a turn, z by `pitch` a turn. [m]
inline cam::Cam snail(double turns, double pitch, double growth, double radius = 0.010) {
    cam::Cam cam = disc(radius);
    cam.kind = cam::PartKind::kParallel;
    cam.options.path.kind = cam::PathKind::kHelix;
    cam.options.path.pitch = pitch;
    const double turn = 2.0 * core::kPi, slope = growth / turn;
    cam.working_psi = {0.0, turns * turn};
    cam.groove_psi = {-0.5, turns * turn + 0.5};
    cam.anchor_psi = -0.3;
    cam.path = [=](double psi) {
        const double h = radius + slope * psi;
        return cam::PathPoint{psi, h, slope, h, pitch / turn * psi};
    };
    return cam;
}

/// Nothing but the groove and a plain bore.
inline PartOptions plain() {
    PartOptions o;
    o.hub.lock = HubLock::kPlain;
    o.features.anchor_hole_diameter = 0.0;
    o.features.mark_width = 0.0;
    return o;
}

}  // namespace fusee::solid::test
