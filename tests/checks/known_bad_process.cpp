#include "checks/known_bad.h"

// The ways to make a part, and putting it together.
namespace fusee::checks {

namespace {

/// Two plates on a post: neither way up do both lie on the bed. The upper plate's 10 x 10 mm and the post's 2 x 2 mm look down.
void bobbin(Fixture& b) {
    b.part.mesh = box({-5, -5, 0}, {5, 5, 2});
    add_box(b.part.mesh, {-1, -1, 2}, {1, 1, 7});
    add_box(b.part.mesh, {-5, -5, 7}, {5, 5, 9});
}

void wide_blind_bore(Fixture& b) {
    solid::HubOptions& hub = b.part.options.hub;
    hub.bore_diameter = 12 * kMm, hub.key_width = 4 * kMm, hub.key_depth = 1.8 * kMm;
    hub.boss_diameter = 24 * kMm, hub.boss_height = 15 * kMm;
}

void set_throat(Fixture& b, double throat_deg) {
    b.part.options.groove.throat = core::rad_from_deg(throat_deg);
    cut_groove(b);
}

/// A pusher from another machine.
void pusher_by(Fixture& b, ProcessKind kind, double clearance_mm) {
    b = pusher();
    b.process.kind = kind;
    b.part.options.hub.bore_clearance = clearance_mm * kMm;
    set_throat(b, 45.0);
}

void thick(Fixture& b, double half_mm) { b.part.z_low = -half_mm * kMm, b.part.z_high = half_mm * kMm; }

/// A cable of 0.4 mm, its end clamped outside.
void thin_cable(Fixture& b) {
    set_cable(b, 0.4 * kMm), without_hole(b);
    b.part.options.groove.rib = b.part.options.features.leg_slot_depth = 1.5 * kMm;
    cut_groove(b);
}

void six_turns(Fixture& b) {
    work(b, 0.0, 12.0 * core::kPi, 20.0 * kMm);
    b.part.cam.groove_psi.high = 12.0 * core::kPi + 1.6 * b.part.cam.options.path.margin;
    cut_groove(b);
}

void narrow_slot(Fixture& b) {
    solid::FeatureOptions& f = b.part.options.features;
    f.leg_slot_width = 0.7 * kMm, f.leg_slot_depth = 1.0 * kMm;
    b.process.cutter_radius = 0.4 * kMm;
    b.spring.wire_diameter = 0.0;
}

void thick_wire(Fixture& b) {
    b.process.cutter_radius = 0.8 * kMm;
    b.part.options.features.anchor_hole_diameter = 1.5 * kMm;
    b.part.options.hub.lock = solid::HubLock::kPlain;
    without_slot(b);
}

/// A bore of 6.61 mm radius in a floor of 9.6 mm about (1, 0): along y the largest circle is c - 6.61 = 9.6 - sqrt(1 + c^2), c = 8.074155
/// mm.
void no_room_for_dowels(Fixture& b) {
    solid::HubOptions& hub = b.part.options.hub;
    hub.bore_diameter = 13.2 * kMm, hub.key_width = 5 * kMm, hub.key_depth = 2.3 * kMm;
    b.part.options.groove.rib = 3.0 * kMm;
    without_slot(b), without_hole(b);
    cut_groove(b);
}

void climbing_plates(Fixture& b) {
    pusher_by(b, ProcessKind::kEdm, 0.02);
    solid::HubOptions& hub = b.part.options.hub;
    hub.kind = solid::HubKind::kThrough;
    hub.boss_height = hub.boss_diameter = 0.0;
}

}  // namespace

std::vector<Case> process_cases() {
    return {
        {"process.build_volume",
         "long",
         spool,
         [](Fixture& b) {
             b.part.mesh = box({0, 0, 0}, {150, 210, 10});
         },
         kRequired,
         210.0,
         200.0,
         1e-6,
         {"cable.free_path"}},
        {"process.build_volume", "small machine", spool, [](Fixture& b) { b.process.build_x = 8 * kMm; }, kRequired, 10.0, 8.0},
        {"process.wall", "thin rib", spool, [](Fixture& b) { b.part.options.groove.rib = 0.5 * kMm; }, kRequired, 0.5, 0.8},
        {"process.wall", "thin flange", spool, [](Fixture& b) { b.part.z_high -= 0.4 * kMm; }, kRequired, 0.6, 0.8},
        {"process.hole", "small", spool, [](Fixture& b) { b.part.options.features.anchor_hole_diameter = 1.5 * kMm; }, kRequired, 1.5, 2.0},
        {"process.detail", "fine mark", spool, [](Fixture& b) { b.part.options.features.mark_width = 0.3 * kMm; }, kReview, 0.3, 0.4},
        {"process.contour_error", "short arm", pusher, [](Fixture& b) { b.part.cam.working[3].arm.arm = 2.5 * kMm; }, kReview, 12.0, 10.0},
        {"process.contour_error",
         "coarse",
         spool,
         [](Fixture& b) { b.process.tolerance = 1.0 * kMm; },
         kReview,
         10.434217,
         10.0,
         1e-6,
         {"groove.lip_height", "cable.knot"}},
        {"fdm.support", "bobbin", spool, bobbin, kReview, 104.0, 25.0},
        {"fdm.bridge", "wide blind bore", pusher, wide_blind_bore, kReview, 12.2, 10.0},
        {"fdm.layers", "coarse layers", spool, [](Fixture& b) { b.process.layer = 0.3 * kMm; }, kReview, 1.4133333, 2.0},
        {"fdm.elephant_foot", "tight bore", spool, [](Fixture& b) { b.part.options.hub.bore_clearance = 0.15 * kMm; }, kReview, 0.15, 0.2},
        // 10 + 1 - 1.5 mm in a bore of 6.2 mm
        {"sla.drain", "blind bore", resin, [](Fixture& b) { pusher_by(b, ProcessKind::kSla, 0.2); }, kReview, 9.5 / 6.2, 1.0},
        {"sla.support", "narrow throat", resin, [](Fixture& b) { set_throat(b, 36.0); }, kReview, 72.0, 71.0},
        {"sls.hole_depth", "thick part", powder, [](Fixture& b) { thick(b, 12.0); }, kReview, 6.0, 5.0},
        // 2 (0.212 cos 22.5 deg + (0.2 - 0.212 (1 - sin 22.5 deg)) tan 22.5 deg)
        {"sls.groove", "thin cable", powder, thin_cable, kReview, 0.448998, 0.5, 1e-5},
    };
}

std::vector<Case> machine_cases() {
    return {
        {"mill.slot_width", "narrow slot", milled, narrow_slot, kRequired, 0.7, 0.8},
        {"mill.pocket", "deep slot", milled,
         [](Fixture& b) { b.part.options.features.leg_slot_depth = 2.2 * kMm, b.part.options.groove.rib = 1.3 * kMm, cut_groove(b); },
         kReview, 2.2 / 0.7, 3.0},
        {"mill.inner_edge", "flat", milled, [](Fixture& b) { b.part.options.hub.lock = solid::HubLock::kDFlat; }, kReview, 0.0, 0.25},
        {"mill.hole_depth", "thick part", milled, [](Fixture& b) { thick(b, 12.0); }, kReview, 6.0, 4.0},
        {"mill.hole_depth", "very thick part", milled, [](Fixture& b) { thick(b, 25.0); }, kRequired, 12.5, 10.0},
        // (1.2 + 1.5) mm over 2 x 0.424 mm
        {"mill4.reach", "high flanges", milled, [](Fixture& b) { b.part.options.flange_height = 1.5 * kMm; }, kReview, 3.1839623, 3.0},
        {"mill4.swing", "small machine", milled, [](Fixture& b) { b.process.build_x = b.process.build_y = 23 * kMm; }, kRequired, 23.6,
         23.0},
        {"stack.wire", "thick wire", plates, thick_wire, kRequired, 0.75, 0.8},
        {"stack.kerf", "wide kerf", plates,
         [](Fixture& b) { b.process.cutter_radius = 0.69 * kMm, b.part.options.hub.lock = solid::HubLock::kPlain; }, kReview, 1.4, 2.07},
        {"stack.groove_width",
         "pinched",
         plates,
         [](Fixture& b) { b.part.options.groove.plate = 0.78 * kMm; },
         kRequired,
         0.975,
         1.0,
         1e-6,
         {"groove.flank_rub"}},
        {"stack.groove_width", "tight", plates, [](Fixture& b) { b.part.options.groove.plate = 0.82 * kMm; }, kReview, 1.025, 1.05},
        {"stack.groove_width", "wide", plates, [](Fixture& b) { b.part.options.groove.plate = 1.4 * kMm; }, kReview, 1.75, 1.5},
        {"stack.plate", "thin cable", plates, thin_cable, kReview, 0.424, 0.5},
        {"stack.hole", "thick flange", plates,
         [](Fixture& b) { b.part.options.groove.rib = b.part.options.features.leg_slot_depth = 2.5 * kMm, cut_groove(b); }, kReview, 0.8,
         1.0},
        {"stack.slot_depth", "half a sheet", plates, [](Fixture& b) { b.part.options.features.leg_slot_depth = 1.3 * kMm; }, kRequired, 0.3,
         0.05},
        {"stack.dowels", "wide bore", plates, no_room_for_dowels, kRequired, 2.928310, 3.0, 5e-3},
        {"stack.boss", "boss", plates,
         [](Fixture& b) { b.part.options.hub.boss_height = 5 * kMm, b.part.options.hub.boss_diameter = 14 * kMm; }, kRequired, 5.0, 0.0},
        // 1.5 turns of 4 mm and 1.6 x 0.35 rad more at both ends
        {"stack.climb", "helix", plates, climbing_plates, kRequired, 6.7130142, 0.0, 1e-5},
        {"collision.ball_cutter", "thick ball", milled, [](Fixture& b) { b.process.cutter_radius = 0.5 * kMm; }, kRequired, 0.424, 0.5},
        // a flank of 60 deg throat lies 30 deg from the horizontal
        {"collision.printed_throat", "rope throat", spool, [](Fixture& b) { set_throat(b, 60.0); }, kRequired, 60.0, 45.0},
        // 6 x 4 mm/(2 tan 2 deg)
        {"collision.printed_land", "six turns", pusher, six_turns, kReview, 343.6354, 300.0, 1e-3},
        {"collision.rim_undercut", "three axes", milled, [](Fixture& b) { b.process.kind = ProcessKind::kMill; }, kReview, 1.2, 0.0},
    };
}

std::vector<Case> assembly_cases() {
    return {
        {"assembly.thread", "tight hole", resin, [](Fixture& b) { b.part.options.features.anchor_hole_diameter = 0.9 * kMm; }, kReview,
         1.125, 1.2},
        {"assembly.thread", "no way through", resin, [](Fixture& b) { b.part.options.features.anchor_hole_diameter = 0.7 * kMm; },
         kRequired, 0.875, 1.0},
        // hole's middle 8.327735 mm from the axis, its radius 1 mm, coils as far as 7.6 mm
        {"assembly.anchor_reach", "wide spring", spool, [](Fixture& b) { without_slot(b), b.spring.coil_diameter = 14 * kMm; }, kReview,
         -0.2722653, 0.0},
        // 2 x 33.333 N/(1.2 mm x 0.8 mm)
        {"assembly.leg_pressure", "shallow slot", spool, [](Fixture& b) { b.part.options.features.leg_slot_depth = 0.8 * kMm; }, kReview,
         69.4444444, 65.0},
        {"assembly.leg_width", "tight slot", spool, [](Fixture& b) { b.part.options.features.leg_slot_width = 1.1 * kMm; }, kRequired, -0.1,
         0.0},
        {"assembly.leg_width", "loose slot", spool, [](Fixture& b) { b.part.options.features.leg_slot_width = 1.9 * kMm; }, kReview, 0.7,
         0.5},
        {"assembly.leg_radius", "small spring", spool, [](Fixture& b) { b.spring.coil_diameter = 10 * kMm; }, kReview, 0.4, 0.0},
        {"assembly.rotation_gap", "near guide", spool, [](Fixture& b) { b.part.cam.options.guide.distance = 12.7 * kMm; }, kReview, 0.5,
         1.0},
    };
}

}  // namespace fusee::checks
