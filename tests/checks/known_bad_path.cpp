#include "checks/known_bad.h"

// Cable, cam and groove.
namespace fusee::checks {

namespace {

void bend(Fixture& b, double rho_mm) {
    for (cam::Contact& c : b.part.cam.working) c.path.rho = rho_mm * kMm;
}

/// Beyond its working arc the groove swings up and down.
void wave(Fixture& b, double height_mm, double waves) {
    b.part.cam.path = [whole = b.part.cam.path, height_mm, waves](double psi) {
        cam::PathPoint p = whole(psi);
        if (psi < 0.0) p.z += height_mm * kMm * (1.0 - std::cos(waves * psi));
        return p;
    };
}

/// One cable that leaves (11, 0) along +y, and a post in its way from y = 5 to 8.
void post_in_the_way(Fixture& b) {
    b.part.cam.working = {b.part.cam.working[kRows / 2]};
    add_box(b.part.mesh, {10.5, 5.0, -1.0}, {12.0, 8.0, 1.0});
}
/// The same cable beginning inside a block that ends at y = 6.
void walled_in(Fixture& b) {
    b.part.cam.working = {b.part.cam.working[kRows / 2]};
    add_box(b.part.mesh, {10.5, -6.0, -1.0}, {12.0, 6.0, 1.0});
}

/// 150 N at the largest wound angle: little of it reaches the knot.
void pull_at_the_far_end(Fixture& b) {
    b.cable.breaking_load = 780.0;
    b.cable.max_pressure = 1e9;
    b.part.cam.working.back().arm.tension = 150.0;
}

/// Cables that rise by 1.9 deg towards a second turn of 100 mm radius, which they meet after about 95 mm: 3.2 mm higher.
void cable_under_a_larger_turn(Fixture& b) {
    b = helix(30.0 * kMm, 4.0 * kMm);
    b.process.material.strength = 100e6;  // its boss holds the longer arms
    b.part.cam.options.guide.kind = cam::GuideKind::kPoint;
    b.cable.max_pressure = 1e9;
    b.part.cam.path = [](double psi) {
        const double h = psi > 2.0 * core::kPi ? 100.0 * kMm : 30.0 * kMm;
        return cam::PathPoint{psi, h, 0.0, h, 4.0 * kMm * psi / (2.0 * core::kPi)};
    };
    work(b, 0.0, 3.0 * core::kPi, 20.0 * kMm);
    b.part.cam.options.torque_sign = -1;
    for (cam::Contact& c : b.part.cam.working) c.fleet = core::rad_from_deg(c.path.psi < 1.5 * core::kPi ? 1.9 : -1.9);
}

/// Floors so flat that the cable passes the lips after 40 mm, sqrt(0.8 (2000 + 0.8)), 1.3272 mm aside.
void flat_and_leaning(Fixture& b) {
    lean(b, 1.9);
    for (const std::size_t row : {7, 8}) b.part.cam.working[row].path.rho = 1.0;
}

/// A parallel exit to a hole, with a disc about (2, 0) mm that works at psi = 0, where its arm is 12 mm, and at 270 deg, with 10 mm: the
/// hole's line is 11 mm from the axis. At 270 deg the disc's centre has turned to (0, 2).
void exit_from_a_disc(Fixture& b, double distance_mm) {
    b.part.cam.path = [](double psi) {
        return cam::PathPoint{psi, (10.0 + 2.0 * std::cos(psi)) * kMm, -2.0 * std::sin(psi) * kMm, 10.0 * kMm,
                              4.0 * kMm * psi / (2.0 * core::kPi)};
    };
    work(b, 0.0, 3.0 * core::kPi, 20.0 * kMm);
    b.part.cam.working = {b.part.cam.working[0], b.part.cam.working[kRows / 2]};
    b.part.cam.options.guide.distance = distance_mm * kMm;
}

void set_groove(Fixture& b, double depth_ratio) {
    b.part.options.groove.depth_ratio = depth_ratio;
    without_hole(b);
    cut_groove(b);
}

}  // namespace

std::vector<Case> cable_cases() {
    return {
        {"cable.bend_ratio", "below critical", spool, [](Fixture& b) { bend(b, 1.8); }, kRequired, 3.5, 4.0},
        {"cable.bend_ratio", "below recommended", spool, [](Fixture& b) { bend(b, 2.8); }, kReview, 6.0, 8.0},
        {"cable.bend_ratio", "own limit", spool, [](Fixture& b) { bend(b, 3.2), b.cable.min_bend_ratio = 8.0; }, kRequired, 7.0, 8.0},
        // on its way to the anchor z = 4 psi/(2 pi) + 0.1 (1 - cos(23 psi)): at the crest z'' = 52.9 mm, z' = 0.63662 mm, rho = 10 mm, so
        // that R = 10 (1 + 0.063662^2)^1.5/sqrt(1 + 0.063662^2 + 5.29^2); sampled within 1/23 of a crest
        {"cable.space_bend", "wavy run out", pusher, [](Fixture& b) { wave(b, 0.1, 23.0); }, kRequired, 3.6715, 4.0, 0.02},
        {"cable.space_bend", "gentler waves", pusher, [](Fixture& b) { wave(b, 0.1, 17.0); }, kReview, 7.2229, 8.0, 0.02},
        // D/d = 2.5: 0.65 + 0.15 ln(1.25)/ln 2
        {"cable.bend_strength", "sharp", spool, [](Fixture& b) { bend(b, 1.4), b.cable.min_bend_ratio = 2.0, b.cable.max_pressure = 1e9; },
         kReview, 69.8289, 70.0, 1e-4},
        // D/d = 24: 0.95 of the strength is left
        {"cable.breaking_load", "far end", spool, pull_at_the_far_end, kReview, 4.94, 5.0},
        {"cable.breaking_load",
         "weak",
         spool,
         [](Fixture& b) { b.cable.breaking_load = 200.0; },
         kReview,
         3.8,
         5.0,
         1e-6,
         {"cable.anchor_load"}},
        {"cable.breaking_load",
         "too weak",
         spool,
         [](Fixture& b) { b.cable.breaking_load = 100.0; },
         kRequired,
         1.9,
         3.0,
         1e-6,
         {"cable.anchor_load"}},
        // 0.5 x 280 N/(50 N e^(-0.05 x 0.35))
        {"cable.anchor_load", "weak knot", spool, [](Fixture& b) { b.cable.breaking_load = 280.0; }, kReview, 2.8494313, 3.0},
        {"cable.anchor_load",
         "weak cable",
         spool,
         [](Fixture& b) { b.cable.breaking_load = 140.0; },
         kRequired,
         1.4247156,
         1.5,
         1e-6,
         {"cable.breaking_load"}},
        {"cable.anchor_tail", "0.1 rad", spool,
         [](Fixture& b) { without_hole(b), b.part.cam.anchor_psi = 2.0 * core::kPi - kWorking - 0.1; }, kReview, 1.0, 1.6},
        {"cable.knot", "wide hole", spool, [](Fixture& b) { b.part.options.features.anchor_hole_diameter = 2.6 * kMm; }, kReview, 3.625,
         3.0},
        {"cable.stated_load", "20 kN", spool, [](Fixture& b) { b.cable.breaking_load = 20e3; }, kRequired, 20e3, 1324.8},
        {"cable.termination", "knotted wire", spool, [](Fixture& b) { b.cable.construction = "7x49", b.cable.breaking_load = 500.0; },
         kReview, 40.0, 50.0},
        // (300 N/50 N) x 6/(5 x 8)
        {"cable.bend_life", "bent under load", spool,
         [](Fixture& b) { bend(b, 2.8), b.cable.min_bend_ratio = 5.0, b.cable.breaking_load = 300.0; }, kReview, 0.9, 1.0},
        {"cable.anchor_edge", "sharp", spool, [](Fixture& b) { b.part.options.features.anchor_edge_radius = 0.2 * kMm; }, kReview, 0.25,
         0.5},
        {"cable.slack", "0.3 N", spool, [](Fixture& b) { b.part.cam.working[0].arm.tension = 0.3; }, kReview, 0.6, 1.0},
        // 2 * 50 N/(19.2 mm * 0.8 mm)
        {"cable.pressure", "soft floor", spool,
         [](Fixture& b) { b.cable.max_pressure = 5e6, b.part.options.hub.lock = solid::HubLock::kPlain, without_slot(b); }, kRequired,
         6.5104167, 5.0},
        {"cable.fleet", "above 2", spool, [](Fixture& b) { lean(b, 3.0); }, kReview, 3.0, 2.0},
        {"cable.fleet", "above 4", spool, [](Fixture& b) { lean(b, 5.0); }, kRequired, 5.0, 4.0},
        {"cable.fleet", "own limit", spool, [](Fixture& b) { lean(b, 1.2), b.cable.max_fleet = core::rad_from_deg(1.0); }, kRequired, 1.2,
         1.0},
        {"cable.fleet_side", "one side", spool, [](Fixture& b) { b.part.cam.working[7].fleet = -core::rad_from_deg(1.8); }, kReview, 1.8,
         1.5},
        // atan(10/(2 pi 10)) while the cable leaves in the plane
        {"cable.groove_angle", "steep helix", pusher, [](Fixture& b) { b = helix(10 * kMm, 10 * kMm); }, kReview, 9.04306108, 4.0},
        {"cable.free_path", "post", spool, post_in_the_way, kRequired, 3.0, 0.0},
        {"cable.free_path", "walled in", spool, walled_in, kRequired, 6.0, 0.0},
    };
}

std::vector<Case> groove_cases() {
    return {
        {"cam.arm_range",
         "bore 18",
         spool,
         [](Fixture& b) { b.part.options.hub.bore_diameter = 18 * kMm, b.part.options.hub.lock = solid::HubLock::kPlain; },
         kRequired,
         9.58385316,
         10.3,
         1e-6,
         {"structure.wall_to_bore", "structure.leg_slot", "structure.anchor", "shaft.hub_length"}},
        {"cam.arm_range", "axis in the groove", pusher,
         [](Fixture& b) { b.part.cam.working[3].arm.arm = 0.3 * kMm, b.process.tolerance = 0.02 * kMm; }, kRequired, 0.3, 0.4},
        // largest h 11, lips 0.8 beyond it; guide at 12 less half a cable
        {"cam.contour_radius", "guide at 12", spool, [](Fixture& b) { b.part.cam.options.guide.distance = 12 * kMm; }, kReview, 11.8, 11.6},
        // lips 0.8 mm beyond a round cam of 10 mm, half a cable: any hole outside is good
        {"cam.parallel_exit", "no distance", pusher, [](Fixture& b) { b.part.cam.options.guide.distance = 0.0; }, kRequired, 0.0, 11.2},
        // the hole is at (11, sqrt(D^2 - 121)): the arm of its tangent to a circle of 10 mm about (0, 2), over 10 mm
        {"cam.parallel_exit", "near hole", pusher, [](Fixture& b) { exit_from_a_disc(b, 20.0); }, kRequired, 1.327255, 1.0},
        {"cam.parallel_exit", "hole at 100 mm", pusher, [](Fixture& b) { exit_from_a_disc(b, 100.0); }, kReview, 0.205234, 0.1},
        // 2 x 50 N/10 mm/(pi 100/3 MPa) x (ln 20 + 1/2) on an arm of 10 + cos 2 = 9.5839 mm
        {"groove.creep", "soft rubber", spool, [](Fixture& b) { b.process.material.modulus = 100e6; }, kReview, 3.4831276, 2.0},
        {"groove.depth", "shallow", spool, [](Fixture& b) { set_groove(b, 1.4); }, kReview, 1.4, 1.5},
        {"groove.depth",
         "flat",
         spool,
         [](Fixture& b) { b.part.options.groove.rib = 2 * kMm, set_groove(b, 0.3); },
         kRequired,
         0.3,
         0.375,
         1e-6,
         {"groove.lip_height"}},
        // lips 0.5 mm beyond the centreline of a cable of 0.5 mm
        {"groove.lip_height", "thin cable", spool,
         [](Fixture& b) { set_cable(b, 0.5 * kMm), b.process.layer = 0.1 * kMm, set_groove(b, 1.5); }, kReview, 0.25, 0.3},
        {"groove.radius", "tight", spool, [](Fixture& b) { b.part.options.groove.radius_ratio = 0.51; }, kReview, 0.51, 0.53},
        {"groove.radius", "too tight", spool, [](Fixture& b) { b.part.options.groove.radius_ratio = 0.49, b.process.layer = 0.1 * kMm; },
         kRequired, 0.49, 0.5},
        {"groove.radius", "wide", spool, [](Fixture& b) { b.part.options.groove.radius_ratio = 0.6; }, kReview, 0.6, 0.55},
        {"groove.throat", "wider than printing needs", spool, [](Fixture& b) { b.part.options.groove.throat = core::rad_from_deg(100); },
         kReview, 100.0, 90.0},
        {"groove.throat", "90 in resin", resin, [](Fixture& b) { b.part.options.groove.throat = core::rad_from_deg(90), cut_groove(b); },
         kReview, 90.0, 45.0},
        {"groove.throat", "narrow for its fleet", resin,
         [](Fixture& b) {
             lean(b, 1.8);
             b.part.options.hub.lock = solid::HubLock::kPlain;
             b.part.options.groove.throat = core::rad_from_deg(50), cut_groove(b);
         },
         kReview, 50.0, 60.0},
        // half the groove 1.3756265, half the cable 0.4
        {"groove.flank_rub", "flat floor", spool, flat_and_leaning, kReview, -0.351572, 0.0, 1e-4},
        // groove 2.751253 mm wide at the lips, wall 0.8, rib 1.0
        {"groove.pitch", "less land than asked", pusher, [](Fixture& b) { b = helix(10 * kMm, 3.6 * kMm); }, kReview, 3.6, 3.7512531},
        {"groove.pitch",
         "no land",
         pusher,
         [](Fixture& b) { b = helix(10 * kMm, 3.0 * kMm); },
         kRequired,
         3.0,
         3.5512531,
         1e-6,
         {"process.wall"}},
        // other turns stand at the cable's own height: clearance -d/2, within a quarter of the sampled spacing d/4
        {"groove.neighbour_turns",
         "turns overlap",
         pusher,
         [](Fixture& b) { b = helix(10 * kMm, 1.0 * kMm); },
         kRequired,
         -0.4,
         0.0,
         0.05,
         {"groove.pitch", "process.wall"}},
        {"groove.neighbour_turns", "larger turn", pusher, cable_under_a_larger_turn, kRequired, -0.4, 0.0, 0.05},
    };
}

}  // namespace fusee::checks
