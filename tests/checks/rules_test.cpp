#include <gtest/gtest.h>

#include <functional>
#include <ostream>
#include <set>

#include "checks/fixture.h"

// Known: every rule is broken by a part whose measure was worked out by hand, and passes its good twin.
namespace fusee::checks {
namespace {

using core::Severity;

struct Case {
    const char* rule;
    const char* name;
    Bench (*twin)();                    ///< passes the rule
    std::function<void(Bench&)> spoil;  ///< makes the bad part of it
    Severity severity;
    double measured, allowed;
    double tolerance = 1e-6;  ///< absolute: the hand's digits; wider where the contour is sampled
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.rule << ' ' << c.name; }

Bench with_screw() {
    Bench b = spool();
    solid::HubOptions& hub = b.part.options.hub;
    hub.lock = solid::HubLock::kSetScrew;
    hub.screw_diameter = 3.0 * kMm;
    hub.boss_diameter = 14.0 * kMm;
    hub.boss_height = 6.0 * kMm;
    return b;
}

Bench keyed_towards_the_floor() { return disc(10.0 * kMm, -1.0 * kMm); }

void bend(Bench& b, double rho_mm) {
    for (cam::Contact& c : b.part.cam.working) c.path.rho = rho_mm * kMm;
}
void lean(Bench& b, double fleet_deg) { b.part.cam.working[7].fleet = -core::rad_from_deg(fleet_deg); }

/// One cable that leaves (11, 0) along +y, and a post in its way from y = 5 to 8.
void post_in_the_way(Bench& b) {
    b.part.cam.working = {b.part.cam.working[kRows / 2]};
    add_box(b.part.mesh, {10.5, 5.0, -1.0}, {12.0, 8.0, 1.0});
}
/// The same cable beginning inside a block that ends at y = 6.
void walled_in(Bench& b) {
    b.part.cam.working = {b.part.cam.working[kRows / 2]};
    add_box(b.part.mesh, {10.5, -6.0, -1.0}, {12.0, 6.0, 1.0});
}

/// Outside the working arc the contour turns as sharply as this.
void pinch_idle(Bench& b, double rho_mm) {
    b.part.cam.path = [whole = b.part.cam.path, working = b.part.cam.working_psi, rho_mm](double psi) {
        cam::PathPoint p = whole(psi);
        if (!working.holds(psi)) p.rho = rho_mm * kMm;
        return p;
    };
}

/// Two plates on a post: neither way up do both lie on the bed. The upper plate's 10 x 10 mm and the post's 2 x 2 mm look down.
void bobbin(Bench& b) {
    b.part.mesh = box({-5, -5, 0}, {5, 5, 2});
    add_box(b.part.mesh, {-1, -1, 2}, {1, 1, 7});
    add_box(b.part.mesh, {-5, -5, 7}, {5, 5, 9});
}

std::vector<Case> cable_cases() {
    return {
        {"cable.bend_ratio", "below critical", spool, [](Bench& b) { bend(b, 1.8); }, Severity::kRequired, 3.5, 4.0},
        {"cable.bend_ratio", "below recommended", spool, [](Bench& b) { bend(b, 2.8); }, Severity::kReview, 6.0, 8.0},
        {"cable.bend_ratio", "own limit", spool, [](Bench& b) { bend(b, 3.2), b.cable.min_bend_ratio = 8.0; }, Severity::kRequired, 7.0,
         8.0},
        // D/d = 24: 0.91 + 0.04 ln(24/20)/ln 2 of the strength is left
        {"cable.breaking_load", "weak", spool, [](Bench& b) { b.cable.breaking_load = 200.0; }, Severity::kReview, 3.6820855, 5.0},
        {"cable.breaking_load", "too weak", spool, [](Bench& b) { b.cable.breaking_load = 100.0; }, Severity::kRequired, 1.84104275, 3.0},
        // 2 * 50 N/(19.2 mm * 0.8 mm)
        {"cable.pressure", "soft floor", spool, [](Bench& b) { b.cable.max_pressure = 5e6; }, Severity::kRequired, 6.5104167, 5.0},
        {"cable.fleet", "above 2", spool, [](Bench& b) { lean(b, 3.0); }, Severity::kReview, 3.0, 2.0},
        {"cable.fleet", "above 4", spool, [](Bench& b) { lean(b, 5.0); }, Severity::kRequired, 5.0, 4.0},
        {"cable.fleet", "own limit", spool, [](Bench& b) { lean(b, 1.2), b.cable.max_fleet = core::rad_from_deg(1.0); },
         Severity::kRequired, 1.2, 1.0},
        // atan(10/(2 pi 10)) while the cable leaves in the plane
        {"cable.groove_angle", "steep helix", pusher, [](Bench& b) { b = helix(10 * kMm, 10 * kMm); }, Severity::kReview, 9.04306108, 4.0},
        {"cable.free_path", "post", spool, post_in_the_way, Severity::kRequired, 3.0, 0.0},
        {"cable.free_path", "walled in", spool, walled_in, Severity::kRequired, 6.0, 0.0},
    };
}

std::vector<Case> groove_cases() {
    return {
        {"cam.arm_range", "bore 18", spool, [](Bench& b) { b.part.options.hub.bore_diameter = 18 * kMm; }, Severity::kRequired, 9.58385316,
         10.3},
        {"cam.arm_range", "axis in the groove", pusher, [](Bench& b) { b.part.cam.working[3].arm.arm = 0.3 * kMm; }, Severity::kRequired,
         0.3, 0.4},
        // largest h 11, lips 0.8 beyond it; guide at 12 less half a cable
        {"cam.contour_radius", "guide at 12", spool, [](Bench& b) { b.part.cam.options.guide.distance = 12 * kMm; }, Severity::kReview,
         11.8, 11.6},
        {"groove.depth", "shallow", spool, [](Bench& b) { b.part.options.groove.depth_ratio = 1.0; }, Severity::kReview, 1.0, 1.5},
        {"groove.depth", "flat", spool, [](Bench& b) { b.part.options.groove.depth_ratio = 0.3; }, Severity::kRequired, 0.3, 0.375},
        {"groove.radius", "tight", spool, [](Bench& b) { b.part.options.groove.radius_ratio = 0.51; }, Severity::kReview, 0.51, 0.53},
        {"groove.radius", "too tight", spool, [](Bench& b) { b.part.options.groove.radius_ratio = 0.49; }, Severity::kRequired, 0.49, 0.5},
        {"groove.radius", "wide", spool, [](Bench& b) { b.part.options.groove.radius_ratio = 0.6; }, Severity::kReview, 0.6, 0.55},
        {"groove.throat", "wider than printing needs", spool, [](Bench& b) { b.part.options.groove.throat = core::rad_from_deg(100); },
         Severity::kReview, 100.0, 90.0},
        {"groove.throat", "90 in resin", spool, [](Bench& b) { b.process.kind = ProcessKind::kSla; }, Severity::kReview, 90.0, 45.0},
        {"groove.throat", "narrow for its fleet", spool,
         [](Bench& b) { lean(b, 1.8), b.part.options.groove.throat = core::rad_from_deg(50); }, Severity::kReview, 50.0, 60.0},
        // groove 2.751253 mm wide at the lips, wall 0.8, rib 1.0
        {"groove.pitch", "less land than asked", pusher, [](Bench& b) { b = helix(10 * kMm, 3.6 * kMm); }, Severity::kReview, 3.6,
         3.7512531},
        {"groove.pitch", "no land", pusher, [](Bench& b) { b = helix(10 * kMm, 3.0 * kMm); }, Severity::kRequired, 3.0, 3.5512531},
        // other turns stand at the cable's own height: clearance -d/2, within a quarter of the sampled spacing d/4
        {"groove.neighbour_turns", "turns overlap", pusher, [](Bench& b) { b = helix(10 * kMm, 1.0 * kMm); }, Severity::kRequired, -0.4,
         0.0, 0.05},
        {"structure.idle_curvature", "below the wish", spool, [](Bench& b) { pinch_idle(b, 1.5); }, Severity::kReview, 1.5, 2.0, 2e-6},
        {"structure.idle_curvature", "cusp", spool, [](Bench& b) { pinch_idle(b, 0.3); }, Severity::kRequired, 0.3, 0.4, 2e-6},
    };
}

std::vector<Case> spring_cases() {
    return {
        {"spring.travel", "own limit", pusher, [](Bench& b) { b.spring.max_state = 18 * kMm; }, Severity::kRequired, 20.0, 18.0},
        // 44 - 10 coils of 2 mm = 24 mm to solid
        {"spring.travel", "83 % of solid", pusher, [](Bench& b) { b.spring.free_length = 44 * kMm; }, Severity::kReview, 20.0, 19.2},
        {"spring.travel", "solid", pusher, [](Bench& b) { b.spring.free_length = 40 * kMm; }, Severity::kRequired, 20.0, 17.0},
        {"spring.torsion_angle", "own limit", spool, [](Bench& b) { b.spring.max_state = 8.0; }, Severity::kRequired, 10.0, 8.0},
        {"spring.load", "torque", spool, [](Bench& b) { b.spring.max_load = 0.15; }, Severity::kRequired, 0.2, 0.15},
        {"spring.load", "force", pusher, [](Bench& b) { b.spring.max_load = 140; }, Severity::kRequired, 149.2, 140.0},
        // C = 10, K_B = 389/360, M = 0.2 Nm
        {"spring.stress", "bending", spool, [](Bench& b) { b.spring.tensile_strength = 1000e6; }, Severity::kRequired, 1273.8945, 800.0,
         1e-4},
        // C = 8, K_W = 31/28 + 0.615/8, F = 149.2 N; 1500 * 0.8/sqrt 3
        {"spring.stress", "shear", pusher, [](Bench& b) { b.spring.tensile_strength = 1500e6; }, Severity::kRequired, 899.6988917,
         692.820323, 1e-4},
        {"spring.buckling", "slender", pusher, [](Bench& b) { b.spring.free_length = 200 * kMm; }, Severity::kReview, 20.0, 14.9995030},
    };
}

std::vector<Case> structure_cases() {
    return {
        // floor 8.6 mm from the axis at psi = pi, bore 7.6; contour sampled at 1 deg: e (1 - cos 0.5 deg) = 4e-5 mm
        {"structure.wall_to_bore", "thin", spool, [](Bench& b) { b.part.options.hub.bore_diameter = 15 * kMm; }, Severity::kReview, 1.0,
         1.2, 1e-4},
        // the key's corner (8.6, 1) in a floor of radius 9.6 about (-1, 0): 9.6 - |(9.6, 1)|
        {"structure.wall_to_bore", "key breaks out", keyed_towards_the_floor, [](Bench& b) { b.part.options.hub.bore_diameter = 15 * kMm; },
         Severity::kRequired, -0.0519430, 0.8, 1e-3},
        {"structure.wall_to_bore", "thin web", pusher, [](Bench& b) { b.part.options.hub.web = 1.0 * kMm; }, Severity::kReview, 1.0, 1.2},
        {"structure.wall_to_bore", "web too thin", pusher, [](Bench& b) { b.part.options.hub.web = 0.5 * kMm; }, Severity::kRequired, 0.5,
         0.8},
        // outer end at radius + 1.2 mm, floor at 8.6 mm
        {"structure.leg_slot", "near the floor", spool, [](Bench& b) { b.part.options.features.leg_slot_radius = 6.6 * kMm; },
         Severity::kReview, 0.8, 1.2, 1e-3},
        {"structure.leg_slot", "too near", spool, [](Bench& b) { b.part.options.features.leg_slot_radius = 7.0 * kMm; },
         Severity::kRequired, 0.4, 0.8, 1e-3},
        {"structure.leg_slot", "near the bore", spool, [](Bench& b) { b.part.options.features.leg_slot_radius = 4.8 * kMm; },
         Severity::kRequired, 0.5, 0.8, 1e-3},
        // hole's middle at (1, 0) + 7 (cos, sin)(-2.35), 3 mm hole and 3.1 mm bore
        {"structure.anchor", "wide hole", spool, [](Bench& b) { b.part.options.features.anchor_hole_diameter = 6 * kMm; },
         Severity::kRequired, 0.2373509, 0.8},
        // floor on a circle of 9.6 mm, hole's middle on one of 9 mm, 0.1 rad apart: sqrt(81 + 92.16 - 172.8 cos 0.1) - 1
        {"structure.anchor_floor", "too near", spool, [](Bench& b) { b.part.cam.anchor_psi = b.part.cam.working_psi.low - 0.1; },
         Severity::kRequired, 0.1060223, 0.4, 1e-3},
        {"shaft.key", "width", spool, [](Bench& b) { b.part.options.hub.key_width = 3 * kMm; }, Severity::kReview, 3.0, 2.0},
        {"shaft.key", "depth", spool, [](Bench& b) { b.part.options.hub.key_depth = 0.8 * kMm; }, Severity::kReview, 0.8, 1.0},
        {"shaft.key", "no such shaft", spool, [](Bench& b) { b.part.options.hub.bore_diameter = 5 * kMm; }, Severity::kReview, 5.0, 6.0},
        {"shaft.screw", "thick", with_screw, [](Bench& b) { b.part.options.hub.screw_diameter = 4 * kMm; }, Severity::kReview, 4.0, 3.0},
        {"shaft.screw", "low boss", with_screw, [](Bench& b) { b.part.options.hub.boss_height = 3 * kMm; }, Severity::kRequired, 3.0, 4.6},
        {"shaft.hub_wall", "thin", with_screw, [](Bench& b) { b.part.options.hub.boss_diameter = 8 * kMm; }, Severity::kReview, 0.9, 1.2},
        {"shaft.hub_wall", "too thin", with_screw, [](Bench& b) { b.part.options.hub.boss_diameter = 7 * kMm; }, Severity::kRequired, 0.4,
         0.8},
    };
}

std::vector<Case> process_cases() {
    return {
        {"process.build_volume", "long", spool,
         [](Bench& b) {
             b.part.mesh = box({0, 0, 0}, {150, 210, 10});
         },
         Severity::kRequired, 210.0, 200.0},
        // a flank of 60 deg throat lies 30 deg from the horizontal
        {"process.overhang", "rope throat", spool, [](Bench& b) { b.part.options.groove.throat = core::rad_from_deg(60), cut_groove(b); },
         Severity::kRequired, 60.0, 45.0},
        {"process.support", "bobbin", spool, bobbin, Severity::kReview, 104.0, 25.0},
        {"process.wall", "thin rib", spool, [](Bench& b) { b.part.options.groove.rib = 0.5 * kMm; }, Severity::kRequired, 0.5, 0.8},
        {"process.wall", "thin flange", spool, [](Bench& b) { b.part.z_high -= 0.4 * kMm; }, Severity::kRequired, 0.6, 0.8},
        {"process.hole", "small", spool, [](Bench& b) { b.part.options.features.anchor_hole_diameter = 1.5 * kMm; }, Severity::kRequired,
         1.5, 2.0},
        {"process.hole", "deep", milled, [](Bench& b) { b.part.z_low = -12 * kMm, b.part.z_high = 12 * kMm; }, Severity::kReview, 6.0, 4.0},
        {"process.cutter", "thick ball", milled, [](Bench& b) { b.process.cutter_radius = 0.5 * kMm; }, Severity::kRequired, 0.424, 0.5},
        {"process.cutter", "narrow slot", milled, [](Bench& b) { b.part.options.features.leg_slot_width = 0.4 * kMm; }, Severity::kRequired,
         0.4, 0.5},
        {"process.undercut", "three axes", spool, [](Bench& b) { b = milled(); }, Severity::kReview, 1.2, 0.0},
        {"process.contour_error", "coarse", spool, [](Bench& b) { b.process.tolerance = 1.0 * kMm; }, Severity::kReview, 10.434217, 10.0},
    };
}

std::vector<Case> all_cases() {
    std::vector<Case> all;
    for (const auto& some : {cable_cases(), groove_cases(), spring_cases(), structure_cases(), process_cases()})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

class KnownBad : public testing::TestWithParam<Case> {};

TEST_P(KnownBad, TripsTheRule) {
    Bench bad = GetParam().twin();
    GetParam().spoil(bad);
    const core::Finding f = gravest(GetParam().rule, bad);
    EXPECT_EQ(f.severity, GetParam().severity) << core::to_line(f);
    EXPECT_NEAR(f.measured, GetParam().measured, GetParam().tolerance) << core::to_line(f);
    EXPECT_NEAR(f.allowed, GetParam().allowed, std::max(1e-6, GetParam().tolerance)) << core::to_line(f);
    EXPECT_EQ(f.rule, GetParam().rule);
    EXPECT_NE(f.suggestion.find_first_of("0123456789"), std::string::npos) << "a change has a number: " << f.suggestion;
    EXPECT_EQ(f.suggestion.find("nan"), std::string::npos) << f.suggestion;
    EXPECT_FALSE(f.what.empty());
    EXPECT_FALSE(f.source.empty());
    EXPECT_EQ(f.where.find(cam::to_string(bad.part.cam.kind)), 0u) << f.where;
}

TEST_P(KnownBad, GoodTwinPasses) {
    for (const core::Finding& f : run_rule(GetParam().rule, GetParam().twin())) EXPECT_EQ(f.severity, Severity::kPass) << core::to_line(f);
}

std::string test_name(const testing::TestParamInfo<Case>& instance) {
    std::string name = std::string(instance.param.rule) + "_" + instance.param.name;
    std::erase_if(name, [](char c) { return c == ' ' || c == '%'; });
    std::replace(name.begin(), name.end(), '.', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Rules, KnownBad, testing::ValuesIn(all_cases()), test_name);

TEST(Rules, EachHasAKnownBadPart) {
    std::set<std::string> tried;
    for (const Case& c : all_cases()) tried.insert(c.rule);
    for (const Rule& rule : rules()) EXPECT_TRUE(tried.count(rule.id)) << rule.id;
}

}  // namespace
}  // namespace fusee::checks
