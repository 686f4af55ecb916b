#include "fusee/assembly/assembly.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "fixture.h"
#include "fusee/assembly/rule.h"
#include "fusee/solid/cutters.h"
#include "gaps.h"

namespace fusee::assembly {
namespace {

const Assembly& pnrvsa() { return shipped_joint("pnrvsa").assembly; }

Assembly with(const AssemblyOptions& options) { return assemble(pnrvsa().drive, 0.03, 0.03, options).value(); }

core::Finding finding(const Assembly& assembly, const std::string& rule) {
    for (const core::Finding& f : check(assembly, {}))
        if (f.rule == rule) return f;
    return {};
}

TEST(Shapes, AreClosedWithTheirVolumes) {
    EXPECT_NEAR(solid::volume_mm3(mesh_of(round(10.0, -1.0, 2.0, 3.0))), core::kPi * 91.0 * 3.0, 3.0);
    EXPECT_NEAR(solid::volume_mm3(mesh_of(box({0, 0, 0}, {4, 5, 2}, {{1.0, 1.0, 0.5}}))), 2.0 * (20.0 - 0.25 * core::kPi), 0.1);
    EXPECT_NEAR(solid::volume_mm3(mesh_of(rod({1, 2, 3}, Eigen::Vector3d::UnitY(), 2.0, 7.0))), core::kPi * 28.0, 1.5);
}

TEST(Shapes, HaveTheirDistances) {
    const auto at = [](double x, double z) { return prism_of(round(5.0, z, z + 2.0), Eigen::Isometry3d(Eigen::Translation3d(x, 0, 0))); };
    EXPECT_NEAR(distance_mm(at(0.0, 0.0), at(13.0, 0.0), 100.0), 3.0, 0.05);
    EXPECT_NEAR(distance_mm(at(0.0, 0.0), at(13.0, 6.0), 100.0), 5.0, 0.05);
    EXPECT_EQ(distance_mm(at(0.0, 0.0), at(9.0, 0.0), 100.0), 0.0);
    EXPECT_EQ(distance_mm(at(0.0, 0.0), at(50.0, 0.0), 10.0), 10.0);
    EXPECT_NEAR(distance_mm({-10, 7, 1}, {10, 7, 1}, at(0.0, 0.0), 100.0), 2.0, 0.05);
}

TEST(Assemblies, BothSidesAreMirrorImages) {
    const Assembly& a = pnrvsa();
    const Pose pose{{0.7, 20.0}, {0.7, 20.0}};
    for (const Body& body : a.bodies) {
        if (body.side != Side::kAgonist) continue;
        const Body& other = *a.find(body.name.substr(0, body.name.rfind('_')) + "_antagonist");
        const solid::Box one = solid::bounding_box(placed_mesh(a, body, pose)), two = solid::bounding_box(placed_mesh(a, other, pose));
        EXPECT_NEAR(one.low_mm[0], -two.high_mm[0], 0.05) << body.name << ": circles begin at different corners";
        EXPECT_NEAR(one.high_mm[1], two.high_mm[1], 0.05) << body.name;
        EXPECT_NEAR(one.low_mm[2], two.low_mm[2] + 2.0 * a.plane_mm, 0.01) << body.name << ": the same of wires across";
        EXPECT_GT(placement(a, other, pose).linear().determinant(), 0.0) << "a body cannot be reflected";
    }
}

TEST(Assemblies, ACapstanCarriesItsSpoolAndTheJointTurnsByTheDifference) {
    const Assembly& a = pnrvsa();
    const Pose pose = pose_of(a, 0.9, 0.5, 0.2);
    EXPECT_NEAR(pose.agonist.payout_mm, 30.0 * 0.9 + 30.0 * 0.2, 1e-9);
    EXPECT_NEAR(pose.antagonist.payout_mm, 30.0 * 0.5 - 30.0 * 0.2, 1e-9);
    EXPECT_NEAR(joint_angle(a, pose), 0.2, 1e-9);
    EXPECT_NEAR(placement(a, *a.find("k_se_agonist"), pose).translation().y() - a.find("k_se_agonist")->rest.translation().y(), -27.0,
                1e-9);
}

TEST(Assemblies, TheBossOfKPeIsTowardsTheCapstanAndTheShaftEndsInIt) {
    const Assembly& a = pnrvsa();
    const solid::Box cam = solid::bounding_box(placed_mesh(a, *a.find("k_pe_agonist"), {})),
                     shaft = solid::bounding_box(placed_mesh(a, *a.find("motor_shaft_agonist"), {})),
                     capstan = solid::bounding_box(placed_mesh(a, *a.find("capstan_agonist"), {}));
    EXPECT_LT(cam.high_mm[2], capstan.low_mm[2]);
    EXPECT_LT(shaft.low_mm[2], cam.high_mm[2] - 10.0);
    EXPECT_GT(shaft.low_mm[2], cam.low_mm[2] + 4.0) << "it does not reach the groove, whose arms are shorter than its radius";
}

TEST(Assemblies, AGuideWithoutAPlaceIsNotModelled) {
    Drive drive = pnrvsa().drive;
    solid::Part parallel = *drive.k_pe;
    parallel.cam.options.guide.kind = cam::GuideKind::kParallel;
    drive.k_pe = std::make_shared<solid::Part>(parallel);
    const auto refused = assemble(drive, 0.03, 0.03, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.refusal().front().rule, "joint.guide");
    EXPECT_EQ(refused.refusal().front().where, "k_pe");
}

// Area of the section of all drums of a body: that of circle less bore.
TEST(Assemblies, TheCapstanHasTheKeywayOfItsShaft) {
    const auto bore_area = [](const Assembly& a) {
        const Extrusion& floor = a.find("capstan_antagonist")->shapes.front();
        double area = core::kPi * floor.radius_mm * floor.radius_mm - solid::volume_mm3(mesh_of(floor)) / floor.length_mm;
        for (const RoundHole& pin : floor.holes) area -= core::kPi * pin.radius_mm * pin.radius_mm;
        return area;
    };
    const solid::HubOptions& hub = pnrvsa().drive.k_pe->options.hub;
    ASSERT_EQ(hub.lock, solid::HubLock::kKeyway);
    EXPECT_NEAR(bore_area(pnrvsa()), solid::area_mm2(solid::bore_outline(hub)), 3.0)
        << "a keyway has 6 mm^2; the rim is a polygon within 0.02 mm";
    Drive drive = pnrvsa().drive;
    solid::Part wide = *drive.k_pe;
    wide.options.hub.key_depth = 0.03;
    drive.k_pe = std::make_shared<solid::Part>(wide);
    const Assembly round = assemble(drive, 0.03, 0.03, {}).value();
    EXPECT_TRUE(round.find("capstan_agonist")->shapes.front().bores.front().front().full()) << "no keyway beyond the rim";
}

/// The drive of pnrvsa with a set screw in K_PE.
Drive screwed() {
    Drive drive = pnrvsa().drive;
    solid::Part k_pe = *drive.k_pe;
    k_pe.options.hub.lock = solid::HubLock::kSetScrew;
    k_pe.options.hub.screw_diameter = 3e-3;
    drive.k_pe = std::make_shared<solid::Part>(k_pe);
    return drive;
}

// The screw presses on a flat of the shaft, which turns capstan and pulley, too.
TEST(Assemblies, BesideASetScrewTheDrumsSitOnTheFlat) {
    const Assembly a = assemble(screwed(), 0.03, 0.03, {}).value();
    for (const char* body : {"capstan_agonist", "joint_pulley", "motor_shaft_antagonist"}) {
        const std::vector<Extrusion>& shapes = a.find(body)->shapes;
        const bool flat = std::any_of(shapes.begin(), shapes.end(), [](const Extrusion& s) {
            return (!s.outline.empty() && !s.outline.front().full()) || (!s.bores.empty() && !s.bores.front().front().full());
        });
        EXPECT_TRUE(flat) << body;
    }
}

/// Is a place inside a part?
bool in_part(const solid::Part& part, const solid::Point2& at, double z_mm) {
    const std::vector<solid::Ring> rings = solid::slice(part.mesh, z_mm);
    return std::count_if(rings.begin(), rings.end(), [&](const solid::Ring& ring) { return solid::holds(ring, at); }) % 2 == 1;
}

// A hole to the top would break into the turns above; around the boss there is room for a knot.
TEST(Anchors, OfAHelixOnABossLeadDown) {
    solid::Part part = *shipped_joint("paper/new_cams").assembly.drive.k_pe;
    ASSERT_TRUE(solid::anchor_leads_down(part.cam, part.options));
    const std::vector<solid::Cutter> cutters = solid::make_cutters(part);
    const auto hole = std::find_if(cutters.begin(), cutters.end(), [](const solid::Cutter& c) { return c.name == "anchor"; });
    ASSERT_NE(hole, cutters.end());
    const solid::Point2 at = hole->outline.front().centre_mm;
    for (double z = core::mm_from_m(part.z_low) + 0.05; z < hole->high_mm; z += 0.5) EXPECT_FALSE(in_part(part, at, z)) << z;
    EXPECT_TRUE(in_part(part, at, hole->high_mm + 0.05)) << "blind";
    EXPECT_TRUE(in_part(part, {at[0], at[1] + 2.0}, core::mm_from_m(part.z_low) + 0.05)) << "beside the hole";
    part.options.hub.boss_diameter = 0.04;
    EXPECT_FALSE(solid::anchor_leads_down(part.cam, part.options)) << "into the boss";
    EXPECT_FALSE(solid::anchor_leads_down(pnrvsa().drive.k_pe->cam, pnrvsa().drive.k_pe->options)) << "a planar part has no turns above";
}

/// Direction of the last hole of a body's shape in a pose, about the body's axis [rad].
double hole_angle(const Assembly& a, const char* name, std::size_t shape, const Pose& pose) {
    const Body& body = *a.find(name);
    const RoundHole& hole = body.shapes[shape].holes.back();
    const Eigen::Vector3d at = placement(a, body, pose).linear() * (body.shapes[shape].frame * Eigen::Vector3d(hole.x_mm, hole.y_mm, 0.0));
    return std::atan2(at.y(), at.x());
}

// The cable is wound from where it leaves the drum to its hole: more by what the drum winds, and never less than the dead wrap.
TEST(Anchors, StandWhereTheWoundCableEnds) {
    const Assembly& a = pnrvsa();
    const auto wound = [](double hole, double leaves, double sense) {
        return std::fmod(sense * (hole - leaves) + 4.0 * core::kPi, 2.0 * core::kPi);
    };
    const double dead = core::kPi / 6.0, end = 0.5 * a.joint_range;
    for (const double turn : {0.0, a.greatest_turn}) {
        const Pose pose = pose_of(a, turn, turn, 0.0);
        EXPECT_NEAR(wound(hole_angle(a, "capstan_agonist", 2, pose), core::kPi, 1.0), dead + turn, 1e-9);
        EXPECT_NEAR(wound(hole_angle(a, "capstan_antagonist", 2, pose), 0.0, -1.0), dead + turn, 1e-9);
    }
    for (const double joint : {-end, 0.0, end}) {
        const Pose pose = pose_of(a, 1.0, 1.0, joint);
        EXPECT_NEAR(wound(hole_angle(a, "joint_pulley", 4, pose), 0.0, 1.0), dead + end + joint, 1e-9);
        EXPECT_NEAR(wound(hole_angle(a, "joint_pulley", 0, pose), core::kPi, -1.0), dead + end - joint, 1e-9);
    }
}

TEST(Rules, MotorsThatAreTooNearMeetTheCarriage) {
    EXPECT_EQ(finding(pnrvsa(), "joint.body_gap").severity, core::Severity::kPass);
    const core::Finding near = finding(with({.motor_distance = 0.180}), "joint.body_gap");
    EXPECT_EQ(near.severity, core::Severity::kError) << core::to_line(near);
    EXPECT_EQ(near.measured, 0.0);
    EXPECT_NE(near.what.find("carriage"), std::string::npos);
}

// The pin meets a post where the joint reaches an end of its range, and none before.
TEST(Stops, ArePlacedAtTheEndsOfTheRange) {
    for (const double range : {1.0, 2.5, 5.0}) {
        const Assembly a = with({.joint_range = range});
        const auto distance = [&](double joint) {
            const Pose pose = pose_of(a, 1.0, 1.0, joint);
            const Body &stop = *a.find("stop_pin"), &stops = *a.find("joint_stops");
            const Prism pin = placed(stop.prisms.back(), placement(a, stop, pose));
            double least = 100.0;
            for (const Prism& post : stops.prisms) least = distance_mm(pin, placed(post, placement(a, stops, pose)), least);
            return least;
        };
        const double end = 0.5 * a.joint_range, radius = a.joint_radius_mm - 0.5 * a.cable_mm - 3.0;
        EXPECT_NEAR(distance(end), 0.0, 0.03) << range;
        EXPECT_NEAR(distance(-end), 0.0, 0.03) << range;
        EXPECT_NEAR(distance(0.9 * end), 0.1 * end * radius, 0.06 * end * radius) << range;
    }
}

// Half a gap of cable beyond both ends of the range, before the carriage meets a bracket; not within it.
TEST(Stops, OfACapstanAreMetBeyondItsRange) {
    const Assembly& a = pnrvsa();
    ASSERT_DOUBLE_EQ(a.spare_turn, 0.5 / 30.0);
    for (const char* side : {"agonist", "antagonist"}) {
        const Body &pin = *a.find(std::string("capstan_pin_") + side), &posts = *a.find(std::string("capstan_stops_") + side);
        const auto middle = [](const Extrusion& shape, const Eigen::Isometry3d& at) -> Eigen::Vector2d {
            return (at * shape.frame).translation().head<2>();
        };
        const auto between = [&](double turn) {  // surfaces of pin and nearest post
            const Pose pose = pose_of(a, turn, turn, 0.0);
            double least = 100.0;
            for (const Extrusion& post : posts.shapes)
                least = std::min(least, (middle(pin.shapes.front(), placement(a, pin, pose)) - middle(post, posts.rest)).norm());
            return least - 4.0;
        };
        EXPECT_NEAR(between(-a.spare_turn), 0.0, 1e-9) << side;
        EXPECT_NEAR(between(a.greatest_turn + a.spare_turn), 0.0, 1e-9) << side;
        for (const double share : {0.0, 0.3, 0.7, 1.0}) EXPECT_GT(between(share * a.greatest_turn), 0.4) << side << share;
    }
}

/// A thin rod along z, far from all else.
Body thin_rod(const std::string& name, Motion motion, double x_mm, double y_mm) {
    Body body{name, Side::kAgonist, motion, Eigen::Isometry3d(Eigen::Translation3d(x_mm, y_mm, 0.0)), {round(0.1, 0.0, 5.0)}, nullptr, {}};
    body.prisms = {prism_of(body.shapes.front(), Eigen::Isometry3d::Identity())};
    return body;
}

// Two rods of 0.1 mm, one of which slides past the other: none of the 33 sampled poses, 1.5 mm apart, sees that they meet.
TEST(Gaps, WhatMeetsBetweenTheSamplesIsFound) {
    Assembly a = pnrvsa();
    const double way = a.capstan_radius_mm * a.greatest_turn, met = -way * 10.5 / 32.0;
    a.bodies = {thin_rod("slider_agonist", Motion::kCarriage, 300.0, 0.0), thin_rod("post_agonist", Motion::kFixed, 300.0, met)};
    const std::vector<Gap> meet = body_gaps(a, 0.9);
    ASSERT_EQ(meet.size(), 1U);
    EXPECT_LT(meet.front().mm, 0.06);
    EXPECT_LT(meet.front().proven_mm, 0.06);
    EXPECT_NEAR(meet.front().pose.agonist.turn, a.greatest_turn * 10.5 / 32.0, 0.02);
    a.bodies[1] = thin_rod("post_agonist", Motion::kFixed, 301.2, met);
    const std::vector<Gap> apart = body_gaps(a, 0.9);
    EXPECT_GE(apart.front().proven_mm, 0.9);
    EXPECT_LE(apart.front().proven_mm, 1.0 + 1e-9);
    EXPECT_TRUE(is_proven(apart.front(), 0.9));
}

TEST(Gaps, NoPoseIsNearerThanProven) {
    for (const char* profile : {"pnrvsa", "paper/new_cams"}) {
        const Assembly& a = shipped_joint(profile).assembly;
        std::mt19937_64 random(7);
        std::uniform_real_distribution<double> share(0.0, 1.0);
        std::vector<Pose> poses;
        for (int i = 0; i < 60; ++i)
            poses.push_back({{share(random) * a.greatest_turn, share(random) * a.greatest_payout_mm},
                             {share(random) * a.greatest_turn, share(random) * a.greatest_payout_mm}});
        for (const Gap& gap : body_gaps(a, 0.9)) {
            EXPECT_TRUE(is_proven(gap, 0.9)) << gap.a << " and " << gap.b;
            const Body &one = *a.find(gap.a), &other = *a.find(gap.b);
            for (const Pose& pose : poses)
                for (const Prism& p : one.prisms)
                    for (const Prism& q : other.prisms)
                        EXPECT_GE(distance_mm(placed(p, placement(a, one, pose)), placed(q, placement(a, other, pose)), 20.0) + 1e-9,
                                  gap.proven_mm)
                            << gap.a << " and " << gap.b;
        }
    }
}

TEST(Rules, ARodInTheWayOfACableIsFound) {
    EXPECT_EQ(finding(pnrvsa(), "joint.cable_gap").severity, core::Severity::kPass);
    Assembly bad = pnrvsa();
    for (Body& body : bad.bodies)
        if (body.name == "rods_agonist") body.rest.translation() += Eigen::Vector3d(12.0, 0.0, 13.0);
    const core::Finding rubs = finding(bad, "joint.cable_gap");
    EXPECT_EQ(rubs.severity, core::Severity::kError) << core::to_line(rubs);
    EXPECT_NE(rubs.what.find("drive cable, agonist passes rods_agonist"), std::string::npos) << rubs.what;
}

TEST(Rules, ASmallPulleyWindsMoreThanATurn) {
    EXPECT_EQ(finding(pnrvsa(), "joint.winding").severity, core::Severity::kPass);
    EXPECT_EQ(finding(assemble(pnrvsa().drive, 0.03, 0.012, {}).value(), "joint.winding").severity, core::Severity::kPass) << "stops";
    const Assembly small = assemble(pnrvsa().drive, 0.03, 0.012, {.joint_range = 8.0}).value();
    EXPECT_EQ(finding(small, "joint.winding").severity, core::Severity::kWarning);
    EXPECT_NEAR(finding(small, "joint.winding").measured, 30.0 + 2.0 * 89.82 * 2.5, 0.5) << "all that the springs allow, below 8 rad";
}

TEST(Rules, ACapstanOfMoreThanATurnNeedsAHelicalGroove) {
    const core::Finding f = finding(shipped_joint("paper/new_cams").assembly, "joint.winding");
    EXPECT_EQ(f.severity, core::Severity::kWarning);
    EXPECT_NEAR(f.measured, 525.9, 0.1);
    EXPECT_NE(f.suggestion.text().find("1.50 turns, 1 mm apart, which is not modelled; or a law that ends at 315 deg"), std::string::npos)
        << f.suggestion.text();
}

// Heads of 5.5 mm stand in two corners of the seat, beside the spring and on the plate.
TEST(Seats, HaveRoomForTheirScrews) {
    for (const char* name : {"pnrvsa", "paper/new_cams"}) {
        const Assembly& a = shipped_joint(name).assembly;
        const Extrusion& seat = a.find("k_pe_seat_agonist")->shapes.front();
        const spring::BaseSpring& s = a.drive.k_pe_spring;
        ASSERT_EQ(seat.holes.size(), 3U) << name;
        for (std::size_t i = 1; i < 3; ++i) {
            const RoundHole& hole = seat.holes[i];
            EXPECT_EQ(hole.radius_mm, 1.7);
            EXPECT_GE(std::hypot(hole.x_mm, hole.y_mm) - 2.75, 0.5e3 * (s.coil_diameter + s.wire_diameter) + 0.3 - 1e-9) << name;
            EXPECT_LE(std::max(std::abs(hole.x_mm), std::abs(hole.y_mm)) + 2.75, seat.half_x_mm + 1e-9) << name;
        }
    }
}

TEST(Bill, HasEveryCableWithItsLength) {
    const std::vector<BillRow> rows = bill_of(pnrvsa());
    for (const char* item :
         {"k_se", "k_pe_mirrored", "torsion spring", "compression spring", "drive cable", "series cable", "parallel cable"})
        EXPECT_TRUE(std::any_of(rows.begin(), rows.end(), [&](const BillRow& row) { return row.item == item; })) << item;
}

std::size_t count_of(const Assembly& a, const std::string& item, const std::string& in_text) {
    const std::vector<BillRow> rows = bill_of(a);
    return static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), [&](const BillRow& row) {
        return row.item == item && (row.size + "; " + row.note).find(in_text) != std::string::npos;
    }));
}

// By hand: the bearing of 6 mm stands 1 mm above K_PE's boss.
TEST(Shafts, AreJudgedAtTheirBearings) {
    const Assembly& a = pnrvsa();
    const core::Finding shaft = finding(a, "joint.shaft_strength");
    const cam::Contact& last = a.drive.k_pe->cam.working.back();
    const Body& k_pe = *a.find("k_pe_agonist");
    const double boss = solid::bounding_box(placed_mesh(a, k_pe, {})).high_mm[2];
    const double lever = boss + 1.0 + 3.0 - (k_pe.rest * Eigen::Vector3d(0.0, 0.0, 1e3 * last.path.z)).z();
    EXPECT_NEAR(lever, 18.4, 0.5);
    const double moment = 1e-3 * lever * last.arm.tension, torque = last.arm.tension * last.arm.arm;
    EXPECT_NEAR(shaft.measured, 16e-6 * std::hypot(1.5 * moment, torque) / (core::kPi * std::pow(6e-3, 3)), 0.1) << core::to_line(shaft);
    EXPECT_EQ(shaft.severity, core::Severity::kPass);
    EXPECT_EQ(count_of(a, "motor shaft", "42CrMo4+QT"), 2U) << "up to one plate from cables of two heights";
    const auto with_bore = [&](double mm) {
        Assembly other = a;
        solid::Part part = *a.drive.k_pe;
        part.options.hub.bore_diameter = 1e-3 * mm;
        other.drive.k_pe = std::make_shared<solid::Part>(part);
        return finding(other, "joint.shaft_strength");
    };
    EXPECT_LT(with_bore(12.0).measured, 0.14 * shaft.measured) << "an eighth, and a bearing 2 mm wider";
    EXPECT_EQ(with_bore(12.0).severity, core::Severity::kPass);
    const core::Finding thin = with_bore(4.0);
    EXPECT_EQ(thin.severity, core::Severity::kError) << core::to_line(thin);
    EXPECT_NE(thin.suggestion.text().find("k_pe.hub.bore_mm = "), std::string::npos) << thin.suggestion.text();
}

// Edges are rounded to 1.5 cables, or half the wall: 2 mm of wall give 2 mm/0.8 mm. A wall of 2.4 mm is thick enough for fibre.
TEST(Guides, ACableNeedsARoundEdge) {
    const auto with_wall = [](double wall, const char* construction) {
        Drive drive = pnrvsa().drive;
        drive.cable.construction = construction;
        return assemble(drive, 0.03, 0.03, {.wall = wall}).value();
    };
    const auto edge = [](const Assembly& a) { return judged_by("joint.guide_edge", a).front(); };
    const core::Finding good = edge(with_wall(2.4e-3, "fibre")), thin = edge(with_wall(2e-3, "fibre")),
                        sharp = edge(with_wall(0.7e-3, "fibre")), wire = edge(with_wall(4e-3, "7x19"));
    EXPECT_EQ(good.severity, core::Severity::kPass) << core::to_line(good);
    EXPECT_NEAR(good.measured, 3.0, 1e-9);
    EXPECT_EQ(thin.severity, core::Severity::kWarning);
    EXPECT_NEAR(thin.measured, 2.5, 1e-9);
    EXPECT_EQ(thin.suggestion.text(), "assembly.wall_mm = 2.4");
    EXPECT_EQ(sharp.severity, core::Severity::kError);
    EXPECT_EQ(wire.severity, core::Severity::kWarning);
    EXPECT_EQ(wire.allowed, 18.0);
    EXPECT_NE(wire.suggestion.text().find("k_se.guide.kind = \"idler\""), std::string::npos) << wire.suggestion.text();
    double arm = 0.0;
    for (const cam::Contact& c : pnrvsa().drive.k_se->cam.working) arm = std::max(arm, c.arm.arm);
    EXPECT_NE(good.what.find(fmt::format("{:.1f} deg", core::deg_from_rad(std::asin(arm / 0.150)))), std::string::npos) << good.what;
}

TEST(Bill, HasWhatLocksEachPartOnItsShaft) {
    for (const char* part : {"k_se", "k_pe", "the capstan", "the joint's pulley"})
        EXPECT_EQ(count_of(pnrvsa(), "key", std::string("in ") + part), 1U) << part;
    EXPECT_EQ(count_of(pnrvsa(), "link screw", "on a circle of 33.8 mm"), 1U);
    const Assembly& flat = shipped_joint("first_prototype").assembly;
    EXPECT_EQ(count_of(flat, "key", "in k_se"), 0U);
    EXPECT_EQ(count_of(flat, "spool axle", "with a flat"), 1U);
    EXPECT_EQ(count_of(pnrvsa(), "spool axle", "with a flat"), 0U);
    for (const char* shaft : {"spool axle", "motor shaft", "joint shaft"})
        EXPECT_GE(count_of(pnrvsa(), shaft, "keyways 2 mm wide and 1.2 mm deep"), 1U) << shaft;
    const Assembly screws = assemble(screwed(), 0.03, 0.03, {}).value();
    EXPECT_EQ(count_of(screws, "set screw", ""), 1U);
    EXPECT_EQ(count_of(screws, "set screw", "ISO 4026, M3 x 5 mm; in the boss of k_pe"), 1U) << "a wall of 5 mm";
    EXPECT_GE(count_of(screws, "motor shaft", "with a flat 0.5 mm deep"), 1U);
    EXPECT_EQ(count_of(screws, "key", ""), 1U) << "of k_se";
}

TEST(Bill, NamesTheWireOfASpringAndItsHand) {
    EXPECT_EQ(count_of(pnrvsa(), "torsion spring", "EN 10270-1 SH"), 1U);
    EXPECT_EQ(count_of(pnrvsa(), "compression spring", "EN 10270-1 SH"), 1U);
    EXPECT_EQ(count_of(pnrvsa(), "torsion spring", "left hand on the agonist's side, right hand on the antagonist's"), 1U);
}

TEST(Bill, NamesHowACableEnds) {
    Assembly crimped = pnrvsa();
    crimped.drive.cable.termination = checks::Termination::kCrimp;
    for (const char* cable : {"drive cable", "series cable", "parallel cable"}) {
        EXPECT_EQ(count_of(pnrvsa(), cable, "30 mm for the knot at each end"), 1U) << cable;
        EXPECT_EQ(count_of(crimped, cable, "30 mm for the crimp at each end"), 1U) << cable;
    }
}

TEST(Bill, NamesTheCableAndTheLoadThatItHolds) {
    Assembly unstated = pnrvsa();
    unstated.drive.cable.breaking_load = 0.0, unstated.drive.cable.construction = "7x19";
    EXPECT_EQ(count_of(pnrvsa(), "series cable", "0.8 mm fibre, cut to"), 1U);
    EXPECT_EQ(count_of(pnrvsa(), "series cable", fmt::format("breaking load at least {:g} N", pnrvsa().drive.cable.breaking_load)), 1U);
    EXPECT_EQ(count_of(unstated, "series cable", "0.8 mm 7x19, cut to"), 1U);
    EXPECT_EQ(count_of(unstated, "series cable", "that of a usual cable"), 1U);
}

// Along the axis the leg reaches through half the gap to the slot's bottom; the other one ends behind the post.
TEST(Bill, NamesTheLegsOfTheTorsionSpringAndTheScrews) {
    const solid::FeatureOptions& slot = pnrvsa().drive.k_se->options.features;
    EXPECT_EQ(count_of(pnrvsa(), "torsion spring", fmt::format("a leg along the axis, {:.1f} mm long", 1e3 * slot.leg_slot_depth + 0.5)),
              1U);
    EXPECT_EQ(count_of(pnrvsa(), "torsion spring",
                       fmt::format("a radial leg that ends {:.1f} mm from the axis",
                                   pnrvsa().leg_post_mm + 2.0 + 1e3 * pnrvsa().drive.k_se_spring.wire_diameter)),
              1U);
    EXPECT_EQ(count_of(pnrvsa(), "torsion spring", "5 mm from the axis, for the slot of k_se"), 1U) << "as assembly.step has it";
    EXPECT_EQ(count_of(pnrvsa(), "torsion spring", "unloaded, the radial leg is 270 deg beyond 25 turns"), 1U);
    for (const char* screw : {"rod screw", "seat screw", "screws of the motors", "frame screw", "rod washer"})
        EXPECT_EQ(count_of(pnrvsa(), screw, ""), 1U) << screw;
    const Assembly& paper = shipped_joint("paper/new_cams").assembly;
    EXPECT_EQ(count_of(paper, "guide tube", "4 mm, bore of 1.2 mm at least"), 1U);
}

TEST(Bill, OrdersNoLegForASlotThatIsNotThere) {
    Assembly bare = pnrvsa();
    solid::Part part = *bare.drive.k_se;
    part.options.features.leg_slot_width = 0.0;
    bare.drive.k_se = std::make_shared<solid::Part>(part);
    EXPECT_EQ(count_of(bare, "torsion spring", "for the slot of k_se"), 0U);
    EXPECT_EQ(count_of(bare, "torsion spring", "k_se has no slot"), 1U);
}

TEST(Bill, HasTheSheetsAndDowelsOfPlates) {
    Assembly cut = shipped_joint("examples/laser_stack").assembly;
    EXPECT_EQ(count_of(cut, "sheet", ""), 0U) << "printed";
    cut.drive.process.kind = checks::ProcessKind::kLaser;
    EXPECT_EQ(count_of(cut, "sheet", "1.5 mm, S235JR+AR (EN 10025-2)"), 4U) << "both flanges of both parts";
    EXPECT_EQ(count_of(cut, "sheet", "1 mm, S235JR+AR (EN 10025-2); cut by k_se_plate_2.dxf and by k_se_mirrored_plate_2.dxf"), 1U);
    EXPECT_EQ(count_of(cut, "dowel", "ISO 2338, 2 x 4 mm; two in the plates of each k_pe"), 1U);
    EXPECT_EQ(count_of(pnrvsa(), "sheet", "") + count_of(pnrvsa(), "dowel", ""), 0U);
    Assembly halves = pnrvsa();
    solid::Part milled = *halves.drive.k_se;
    milled.options.dowel_diameter = 2e-3;
    halves.drive.k_se = std::make_shared<solid::Part>(milled);
    EXPECT_EQ(count_of(halves, "dowel", "ISO 8734, 2 m6 x 4 mm; two in the half plates of each k_se"), 1U);
}

TEST(Bill, KeysHaveALengthThatIsSold) {
    EXPECT_EQ(count_of(pnrvsa(), "key", "11.5 mm long, cut from 12 mm; in k_pe"), 1U) << "as deep as the blind bore";
    EXPECT_EQ(count_of(pnrvsa(), "key", "4.8 mm long, cut from 6 mm; in k_se"), 1U);
}

TEST(Docs, TheTableOfRulesHasEveryRule) {
    for (const Rule& rule : rules())
        EXPECT_NE(checks::reference(checks::infos_of(rules())).find(std::string("| `") + rule.id + "` |"), std::string::npos) << rule.id;
}

}  // namespace
}  // namespace fusee::assembly
