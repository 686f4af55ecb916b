#include "checks/known_bad.h"

// Structure, shaft and hub.
namespace fusee::checks {

namespace {

Fixture keyed_towards_the_floor() { return disc(10.0 * kMm, -1.0 * kMm); }

/// Half way round its idle arc the contour turns as sharply as this.
void pinch_idle(Fixture& b, double rho_mm) {
    b.part.cam.path = [whole = b.part.cam.path, rho_mm](double psi) {
        cam::PathPoint p = whole(psi);
        if (psi > 2.5 && psi < 3.5) p.rho = rho_mm * kMm;
        return p;
    };
}

void wide_bore(Fixture& b) {
    solid::HubOptions& hub = b.part.options.hub;
    hub.lock = solid::HubLock::kPlain;
    hub.bore_diameter = 15 * kMm;
    hub.boss_diameter = 20 * kMm, hub.boss_height = 4 * kMm;
    without_slot(b), without_hole(b);
}

/// The slot under the anchor hole, whose middle lies at (1, 0) + 9 (cos, sin)(-2.35).
void slot_at_the_anchor(Fixture& b) {
    b.part.options.features.leg_slot_angle = std::atan2(9.0 * std::sin(-2.35), 1.0 + 9.0 * std::cos(-2.35));
}

void small_spool_with_a_wide_hole(Fixture& b) {
    b = disc(5.0 * kMm, 0.0);
    b.part.options.hub = pusher().part.options.hub;
    b.part.options.features.anchor_hole_diameter = 2.4 * kMm;
    b.overrides = {{"cable.knot", "review_d", 3.5, "a double knot"}};
    b.part.cam.anchor_psi = b.part.cam.working_psi.low - 0.325;
    b.spring.coil_diameter = 0.0;
    without_slot(b);
}

/// A core of 1.6 mm between two floors, on a contour that bends no cable sharply.
void thin_core(Fixture& b) {
    b = helix(1.2 * kMm, 4.0 * kMm);
    b.part.cam.path = [](double psi) { return cam::PathPoint{psi, 1.2 * kMm, 0.0, 10.0 * kMm, 4.0 * kMm * psi / (2.0 * core::kPi)}; };
    work(b, 0.0, 3.0 * core::kPi, 20.0 * kMm);
    b.process.tolerance = 0.1 * kMm;
    without_hole(b);
}

void keyed_bore(Fixture& b, double bore_mm, double width_mm, double depth_mm) {
    solid::HubOptions& hub = b.part.options.hub;
    hub.bore_diameter = bore_mm * kMm, hub.key_width = width_mm * kMm, hub.key_depth = depth_mm * kMm;
    without_slot(b);
}

/// Equivalent stress [MPa] at the root of the pusher's boss where the cable runs `z_mm` above the start of its groove.
double layer_stress(double z_mm, double outside_mm = 7.0) {
    const double half_groove = core::mm_from_m(-pusher().part.z_low), inside_mm = std::hypot(4.1, 1.0);
    const double second_moment = 0.25 * core::kPi * (std::pow(outside_mm, 4) - std::pow(inside_mm, 4));
    const double bending = 50.0 * (z_mm + half_groove) * outside_mm / second_moment,
                 torsion = 50.0 * 10.0 * outside_mm / (2.0 * second_moment);
    return std::sqrt(bending * bending + 4.0 * torsion * torsion);
}

/// The pusher from a mill, bonded to its shaft; the sharp corners of a keyway are accepted.
Fixture milled_pusher() {
    Fixture b = pusher();
    b.process.kind = ProcessKind::kMill4;
    b.part.options.hub.bore_clearance = 0.03 * kMm;
    b.part.options.hub.lock = solid::HubLock::kPlain;
    b.part.options.groove.throat = core::rad_from_deg(45.0);
    cut_groove(b);
    b.overrides.push_back({"mill.inner_edge", "review_mm", 0.0, "eroded"});
    return b;
}

}  // namespace

std::vector<Case> structure_cases() {
    return {
        // floor 8.6 mm from the axis at psi = pi, bore 7.6; contour sampled at 1 deg: e (1 - cos 0.5 deg) = 4e-5 mm
        {"structure.wall_to_bore", "thin", spool, wide_bore, kReview, 1.0, 1.2, 1e-4},
        // the key's corner (8.6, 1) in a floor of radius 9.6 about (-1, 0): 9.6 - |(9.6, 1)|
        {"structure.wall_to_bore",
         "key breaks out",
         keyed_towards_the_floor,
         [](Fixture& b) { keyed_bore(b, 15.0, 2.0, 1.0), without_hole(b); },
         kRequired,
         -0.0519430,
         0.8,
         1e-3,
         {"shaft.key", "shaft.hub_length"}},
        {"structure.wall_to_bore", "thin web", pusher, [](Fixture& b) { b.part.options.hub.web = 1.0 * kMm; }, kReview, 1.0, 1.2},
        {"structure.wall_to_bore", "web too thin", pusher, [](Fixture& b) { b.part.options.hub.web = 0.5 * kMm; }, kRequired, 0.5, 0.8},
        {"structure.neck", "thin core", pusher, thin_core, kReview, 1.6, 2.0},
        {"structure.idle_curvature", "below the wish", spool, [](Fixture& b) { pinch_idle(b, 1.5); }, kReview, 1.5, 2.0, 2e-6},
        {"structure.idle_curvature", "cusp", spool, [](Fixture& b) { pinch_idle(b, 0.3); }, kRequired, 0.3, 0.4, 2e-6},
        // outer end at radius + 1.2 mm, floor at 8.6 mm
        {"structure.leg_slot", "near the floor", spool,
         [](Fixture& b) { b.part.options.features.leg_slot_radius = 6.6 * kMm, b.spring.coil_diameter = 13.2 * kMm; }, kReview, 0.8, 1.2,
         1e-3},
        {"structure.leg_slot", "too near", spool,
         [](Fixture& b) { b.part.options.features.leg_slot_radius = 7.0 * kMm, b.spring.coil_diameter = 0.0; }, kRequired, 0.4, 0.8, 1e-3},
        {"structure.leg_slot", "near the bore", spool,
         [](Fixture& b) { b.part.options.features.leg_slot_radius = 4.8 * kMm, b.spring.coil_diameter = 9.6 * kMm; }, kRequired, 0.5, 0.8,
         1e-3},
        {"structure.slot_floor", "deep slot", spool, [](Fixture& b) { b.part.options.features.leg_slot_depth = 3.8 * kMm; }, kReview,
         0.9512531, 1.2},
        {"structure.slot_floor", "through", spool, [](Fixture& b) { b.part.options.features.leg_slot_depth = 5.0 * kMm; }, kRequired,
         -0.2487469, 0.8},
        // 8.327735 mm from the axis, the slot ends at 7.2 mm, the hole's radius is 1 mm
        {"structure.anchor", "slot beside it", spool, slot_at_the_anchor, kRequired, 0.1277347, 0.8},
        // hole's middle at (1, 0) + 7 (cos, sin)(-2.35), 3 mm hole and 3.1 mm bore
        {"structure.anchor",
         "wide hole",
         spool,
         [](Fixture& b) { b.part.options.features.anchor_hole_diameter = 6 * kMm; },
         kRequired,
         0.2373509,
         0.8,
         1e-6,
         {"cable.knot", "assembly.anchor_reach"}},
        // floor on a circle of 9.6 mm, hole's middle on one of 9 mm, 0.1 rad apart: sqrt(81 + 92.16 - 172.8 cos 0.1) - 1
        {"structure.anchor_floor",
         "too near",
         spool,
         [](Fixture& b) { b.part.cam.anchor_psi = b.part.cam.working_psi.low - 0.1; },
         kRequired,
         0.1060223,
         0.4,
         1e-3,
         {"cable.anchor_tail"}},
        // floor on a circle of 4.6 mm, hole's middle on one of 3.8 mm, 0.325 rad apart
        {"structure.anchor_floor", "wide hole", spool, small_spool_with_a_wide_hole, kRequired, 0.3716649, 0.4, 1e-3},
        // lips, and with them the rim, 0.7 mm beyond the pitch curve that the hole touches
        {"structure.hole_edge", "thin cable", spool,
         [](Fixture& b) { set_cable(b, 0.7 * kMm), b.process.layer = b.process.tolerance = 0.1 * kMm, cut_groove(b); }, kReview, 0.7, 0.8,
         1e-3},
        // 6 x 0.4 mm x (50 N/10 mm) tan 2 deg/(1.8 mm)^2; 20/50 of 0.25 MPa
        {"structure.flange_bending", "wax", spool, [](Fixture& b) { b.process.material.strength = 0.25e6; }, kReview, 0.12933617, 0.1},
        // 50 N at 6 mm and the groove's half height above the root, and at 10 mm of arm; ring of 14 mm outside, the key's corner inside
        {"structure.layer_strength", "weak plastic", pusher, [](Fixture& b) { b.process.material.strength = 8e6; }, kReview,
         4.0 / layer_stress(6.0), 2.0, 1e-6},
        {"structure.layer_strength", "thin boss", pusher,
         [](Fixture& b) { b.process.material.strength = 8e6, b.part.options.hub.boss_diameter = 12 * kMm; }, kRequired,
         4.0 / layer_stress(6.0, 6.0), 1.0, 1e-6},
        {"structure.flange_slenderness", "high flange", spool, [](Fixture& b) { b.part.options.flange_height = 5 * kMm; }, kReview, 6.2,
         5.0},
    };
}

std::vector<Case> shaft_cases() {
    return {
        {"shaft.blind_keyway", "no way out", milled_pusher, [](Fixture& b) { b.part.options.hub.lock = solid::HubLock::kKeyway; }, kReview,
         0.0, 2.0},
        {"shaft.bore_fit", "rattles", spool, [](Fixture& b) { b.part.options.hub.bore_clearance = 0.5 * kMm; }, kReview, 0.5, 0.4},
        {"shaft.bore_fit", "does not go on", resin, [](Fixture& b) { b.part.options.hub.bore_clearance = 0.1 * kMm; }, kReview, 0.1, 0.15},
        {"shaft.hub_length", "thin disc", spool, [](Fixture& b) { keyed_bore(b, 10.0, 3.0, 1.4); }, kReview, 0.4751253, 0.5},
        // 5 + 1 - 1.5 mm of bore
        {"shaft.hub_length",
         "short boss",
         pusher,
         [](Fixture& b) { b.part.options.hub.boss_height = 5 * kMm; },
         kReview,
         0.75,
         1.0,
         1e-6,
         {"shaft.tilt"}},
        {"shaft.hub_wall", "thin", with_screw, [](Fixture& b) { b.part.options.hub.boss_diameter = 8 * kMm; }, kReview, 0.9, 1.2},
        {"shaft.hub_wall", "too thin", with_screw, [](Fixture& b) { b.part.options.hub.boss_diameter = 7 * kMm; }, kRequired, 0.4, 0.8},
        {"shaft.key", "width", spool, [](Fixture& b) { b.part.options.hub.key_width = 3 * kMm; }, kReview, 3.0, 2.0},
        {"shaft.key", "depth", spool, [](Fixture& b) { b.part.options.hub.key_depth = 0.8 * kMm; }, kReview, 0.8, 1.0},
        {"shaft.key", "no such shaft", spool, [](Fixture& b) { b.part.options.hub.bore_diameter = 5 * kMm; }, kReview, 5.0, 6.0},
        // 2 x 50 N x 11 mm/(6 mm x 0.8 mm x 4.7512531 mm)
        {"shaft.key_pressure", "soft hub", spool, [](Fixture& b) { b.cable.max_pressure = 30e6; }, kReview, 48.232875, 30.0, 1e-3},
        {"shaft.key_fit", "as printed", spool, [](Fixture& b) { b.part.options.hub.key_fit = solid::KeyFit::kAsMade; }, kReview, 0.3,
         0.0125},
        // atan(0.2/4.5); 5 + 1 - 1.5 mm of bore
        {"shaft.tilt",
         "short boss",
         pusher,
         [](Fixture& b) { b.part.options.hub.boss_height = 5 * kMm; },
         kReview,
         core::deg_from_rad(std::atan(0.2 / 4.5)),
         2.0,
         1e-6,
         {"shaft.hub_length"}},
        {"shaft.tilt", "loose bore", pusher,
         [](Fixture& b) { b.part.options.hub.bore_clearance = 0.39 * kMm, b.part.options.hub.boss_height = 11 * kMm; }, kReview,
         core::deg_from_rad(std::atan(0.39 / 10.5)), 2.0},
        // 0.875 pi 3 mm x 2 mm x 25 MPa against 2 x 0.55 Nm/(0.25 x 6 mm)
        {"shaft.thread_strip", "thin boss", with_screw,
         [](Fixture& b) { b.process.material.strength = 50e6, b.part.options.hub.boss_diameter = 10 * kMm; }, kRequired, 0.5622737, 1.0},
        {"shaft.screw", "thick", with_screw, [](Fixture& b) { b.part.options.hub.screw_diameter = 4 * kMm; }, kReview, 4.0, 3.0},
        {"shaft.screw", "low boss", with_screw, [](Fixture& b) { b.part.options.hub.boss_height = 3 * kMm; }, kRequired, 3.0, 4.6},
        // 50 N x 11 mm; 1.5 (2/4.17)^2
        {"shaft.screw_torque", "thin", with_screw, [](Fixture& b) { b.part.options.hub.screw_diameter = 2 * kMm; }, kRequired, 0.55,
         0.3450452, 1e-4},
        {"shaft.d_flat", "shallow", spool,
         [](Fixture& b) { b.part.options.hub.lock = solid::HubLock::kDFlat, b.part.options.hub.flat_depth = 0.24 * kMm; }, kReview, 0.04,
         0.05},
        {"shaft.d_flat", "half a shaft", spool,
         [](Fixture& b) { b.part.options.hub.lock = solid::HubLock::kDFlat, b.part.options.hub.flat_depth = 1.8 * kMm; }, kReview, 0.3,
         0.25},
    };
}

}  // namespace fusee::checks
