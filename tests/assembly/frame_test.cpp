#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>

#include "fixture.h"
#include "fusee/assembly/rule.h"
#include "fusee/assembly/to_make.h"
#include "layout.h"

namespace fusee::assembly {
namespace {

constexpr std::array kJoints{"pnrvsa", "free_curve", "paper/new_cams", "first_prototype"};

Assembly again(const Assembly& a, const AssemblyOptions& options) {
    return assemble(a.drive, 1e-3 * a.capstan_radius_mm, 1e-3 * a.joint_radius_mm, options).value();
}

/// Radii of the holes of a body around a line through `at` along `axis`, where the line passes the shape that has the hole.
std::vector<double> holes_around(const Body& body, const Eigen::Vector3d& at, const Eigen::Vector3d& axis) {
    std::vector<double> radii;
    for (const Extrusion& shape : body.shapes) {
        if (std::abs(shape.frame.linear().col(2).dot(axis)) < 1.0 - 1e-9) continue;
        const Eigen::Vector3d local = shape.frame.inverse() * at;
        for (const RoundHole& hole : shape.holes)
            if (std::hypot(hole.x_mm - local.x(), hole.y_mm - local.y()) < 1e-6) radii.push_back(hole.radius_mm);
    }
    return radii;
}

// Each in the size of its bearing (ISO 15) or of the rod, and in one hole of each body that holds it.
TEST(Frame, EveryShaftAndRodPassesOneHole) {
    for (const char* name : kJoints) {
        SCOPED_TRACE(name);
        const Assembly& a = shipped_joint(name).assembly;
        const double shaft = core::mm_from_m(a.drive.k_pe->options.hub.bore_diameter), seat = 0.5 * bearing_seat_mm(shaft);
        const std::vector<double> one_seat{seat}, one_rod{kRod_mm};
        const Eigen::Vector3d up = Eigen::Vector3d::UnitZ(), along = Eigen::Vector3d::UnitY();
        EXPECT_EQ(holes_around(*a.find("frame_plate"), Eigen::Vector3d::Zero(), up), one_seat);
        for (const char* side : {"agonist", "antagonist"}) {
            const Body &motor = *a.find(std::string("motor_shaft_") + side), &rods = *a.find(std::string("rods_") + side);
            EXPECT_EQ(holes_around(*a.find("frame_plate"), motor.rest.translation(), up), one_seat) << side;
            EXPECT_EQ(holes_around(*a.find("frame_rear"), motor.rest.translation(), up), one_seat) << side;
            for (const Extrusion& rod : rods.shapes)
                for (const char* bracket : {"frame_front", "frame_rear"})
                    EXPECT_EQ(holes_around(*a.find(bracket), rods.rest * rod.frame.translation(), along), one_rod) << bracket << side;
        }
    }
}

// Heads of M3 are 5.5 mm wide: 1.05 mm more than their holes on each side.
TEST(Frame, ThePlateHoldsItsHolesApartAndFarFromItsEdge) {
    for (const char* name : kJoints) {
        SCOPED_TRACE(name);
        const Assembly& a = shipped_joint(name).assembly;
        const Extrusion& plate = a.find("frame_plate")->shapes.front();
        const solid::Ring ring = solid::ring_of(plate.outline, 0.01);
        ASSERT_EQ(plate.holes.size(), a.frame_holes.size());
        for (std::size_t i = 0; i < plate.holes.size(); ++i) {
            const RoundHole& hole = plate.holes[i];
            for (std::size_t j = 0; j < i; ++j)
                EXPECT_GT(std::hypot(hole.x_mm - plate.holes[j].x_mm, hole.y_mm - plate.holes[j].y_mm),
                          hole.radius_mm + plate.holes[j].radius_mm + 2.2)
                    << a.frame_holes[i].holds << " and " << a.frame_holes[j].holds;
            for (std::size_t k = 0; k < ring.size(); ++k) {  // convex and counter-clockwise: left of every edge
                const solid::Point2 &p = ring[k], &q = ring[(k + 1) % ring.size()];
                const double length = std::hypot(q[0] - p[0], q[1] - p[1]);
                const double inside = ((q[0] - p[0]) * (hole.y_mm - p[1]) - (q[1] - p[1]) * (hole.x_mm - p[0])) / length;
                EXPECT_GE(inside, hole.radius_mm + 1.9) << a.frame_holes[i].holds;
            }
        }
    }
}

TEST(Frame, ClearsWhatMoves) {
    for (const char* name : kJoints)
        for (const core::Finding& f : check(shipped_joint(name).assembly, {})) {
            if (f.rule != "joint.body_gap" && f.rule != "joint.cable_gap") continue;
            EXPECT_EQ(f.severity, core::Severity::kPass) << name << core::to_line(f);
        }
    Assembly low = shipped_joint("pnrvsa").assembly;
    for (Body& body : low.bodies)
        if (body.name == "frame_plate") body.rest.translation().z() -= 3.0;
    const core::Findings all = check(low, {});
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [](const core::Finding& f) {
        return f.rule == "joint.body_gap" && f.severity == core::Severity::kError && f.what.find("frame_plate") != std::string::npos;
    })) << "into the axle";
}

// ISO 7089, M3: 7 mm wide, around the rods' ends.
TEST(Frame, TheArmsAreBelowTheWashersOfTheRods) {
    for (const char* name : kJoints) {
        const Assembly& a = shipped_joint(name).assembly;
        const auto& shapes = a.find("frame_rear")->shapes;
        for (const auto& [arm, side] :
             {std::pair(shapes[shapes.size() - 2], "rods_agonist"), std::pair(shapes.back(), "rods_antagonist")}) {
            const Body& rods = *a.find(side);
            const double washer = (rods.rest * rods.shapes.front().frame).translation().z() - 3.5;
            EXPECT_LE(arm.frame.translation().z() + arm.length_mm, washer - 0.49) << name << side;
        }
    }
}

TEST(Frame, CanBeLeftOut) {
    const Assembly &with = shipped_joint("pnrvsa").assembly, without = again(with, {.frame = false});
    EXPECT_EQ(without.find("frame_plate"), nullptr);
    EXPECT_TRUE(without.frame_holes.empty());
    EXPECT_EQ(without.bodies.size() + 11, with.bodies.size())
        << "plate, two brackets, tower, posts, bearings, joint's shaft, capstans' stops";
    const auto length = [](const Assembly& a) {
        double whole = 0.0;  // of both rods
        for (const Extrusion& piece : a.find("rods_agonist")->shapes) whole += 0.5 * piece.length_mm;
        return whole;
    };
    EXPECT_NEAR(length(with) - length(without), 32.0 + 1.0, 1e-9) << "two brackets of 16 mm, and a gap behind the carriage";
}

// An overhung K_PE of the other sense would stand above its capstan: its mirror image takes that side, so that the joint is the same.
TEST(Frame, HasTheMirrorImageOfAnOverhungKPeWhereThatHangsBelow) {
    const Assembly& one = shipped_joint("pnrvsa").assembly;
    Drive drive = one.drive;
    drive.k_pe = std::make_shared<solid::Part>(solid::mirrored(*drive.k_pe));
    const Assembly other = assemble(drive, 0.03, 0.03, {}).value();
    EXPECT_FALSE(one.drive.k_pe_mirrored);
    EXPECT_TRUE(other.drive.k_pe_mirrored);
    ASSERT_EQ(other.bodies.size(), one.bodies.size());
    for (std::size_t i = 0; i < one.bodies.size(); ++i) {
        EXPECT_EQ(other.bodies[i].name, one.bodies[i].name);
        EXPECT_TRUE(other.bodies[i].rest.isApprox(one.bodies[i].rest, 1e-12)) << one.bodies[i].name;
        if (!one.bodies[i].cam) continue;
        EXPECT_EQ(other.bodies[i].cam->points_mm, one.bodies[i].cam->points_mm) << one.bodies[i].name;
    }
    const auto note = [](const Assembly& a, const std::string& item) {
        const std::vector<BillRow> rows = bill_of(a);
        return std::find_if(rows.begin(), rows.end(), [&](const BillRow& row) { return row.item == item; })->note;
    };
    EXPECT_EQ(note(one, "k_pe"), "made by fusee");
    EXPECT_EQ(note(other, "k_pe"), "made by fusee; on the antagonist's side");
    EXPECT_EQ(note(other, "k_pe_mirrored"), "made by fusee; on the agonist's side");
}

TEST(Stops, ACapstanWithoutRoomIsStoppedByWhoeverBuildsTheFrame) {
    const Assembly& a = shipped_joint("pnrvsa").assembly;
    const auto row = [](const Assembly& b) {
        const std::vector<BillRow> rows = bill_of(b);
        return *std::find_if(rows.begin(), rows.end(), [](const BillRow& r) { return r.item.starts_with("capstan stop"); });
    };
    EXPECT_EQ(row(a).item, "capstan stop pin");
    const double least = 0.5 * bearing_seat_mm(6.0) + 6.0 + 0.4;  // to the floor, and half a cable
    const auto with_capstan = [&](double mm) { return assemble(a.drive, 1e-3 * mm, 0.03, {}).value(); };
    EXPECT_NE(with_capstan(least + 0.01).find("capstan_pin_agonist"), nullptr);
    const Assembly small = with_capstan(least - 0.01);
    EXPECT_EQ(small.find("capstan_pin_agonist"), nullptr);
    EXPECT_EQ(row(small).count, 0);
    EXPECT_NE(row(small).note.find(fmt::format("at -{:.1f} and ", core::deg_from_rad(0.5 / (least - 0.01)))), std::string::npos)
        << row(small).note;
    EXPECT_EQ(row(again(a, {.frame = false})).count, 0);
}

// Towards the carriages a post would stand in their way.
TEST(Frame, HasPostsWhereTheyFindAWayToThePlate) {
    const Assembly& a = shipped_joint("pnrvsa").assembly;
    EXPECT_NE(a.find("k_pe_posts"), nullptr);
    const Assembly outwards = again(a, {.k_pe_direction = 0.0});
    EXPECT_EQ(outwards.find("k_pe_posts"), nullptr);
    EXPECT_NE(outwards.find("frame_plate"), nullptr);
}

// With and without a frame: what is made has a file in the bill, and the bill no other file.
TEST(Bill, NamesTheFilesOfTheBodiesThatTheWorkshopMakes) {
    const Assembly& framed = shipped_joint("pnrvsa").assembly;
    for (const Assembly& a : {framed, again(framed, {.frame = false})}) {
        std::set<std::string> made, named;
        for (const Body* body : bodies_to_make(a)) {
            EXPECT_FALSE(body->cam) << body->name;
            made.insert(body->base_name() + (body->side == Side::kAntagonist ? "_mirrored.stl" : ".stl"));
        }
        const std::regex file("[a-z_]+[.]stl");
        for (const BillRow& row : bill_of(a))
            for (std::sregex_iterator at(row.size.begin(), row.size.end(), file), end; at != end; ++at)
                EXPECT_TRUE(named.insert(at->str()).second) << at->str() << " stands twice";
        EXPECT_EQ(made, named);
        EXPECT_EQ(made.size(), a.find("frame_plate") != nullptr ? 14U : 9U);
    }
}

// Every body that is made has a sheet: each hole says what it is for, bores have their fit and key, and no text leaves the frame.
TEST(Sheets, OfAllBodiesThatAreMade) {
    for (const char* name : kJoints) {
        const Assembly& a = shipped_joint(name).assembly;
        for (const Body* body : bodies_to_make(a)) {
            SCOPED_TRACE(body->name);
            const drawing::SheetBody shown = sheet_of(a, *body);
            const checks::Process process = process_of(a, *body);
            const drawing::Sheet sheet =
                drawing::draw_sheet({*a.drive.k_pe, a.drive.k_pe_spring, a.drive.cable, process, name, body->name, "test"}, shown);
            std::string words;
            for (const drawing::Text& text : sheet.texts) {
                words += text.words + "\n";
                EXPECT_TRUE(drawing::Sheet::kFrame.holds(drawing::box_of(text))) << text.words;
            }
            for (const drawing::BodyHole& hole : drawing::holes_of(shown.shapes)) EXPECT_NE(shown.use(hole), "");
            const bool drum = body->base_name() == "capstan" || body->name == "joint_pulley", locked = drum && shown.locked;
            EXPECT_EQ(words.find("Bore for a shaft of") != std::string::npos, drum);
            EXPECT_EQ(words.find("keyway DIN 6885-1") != std::string::npos,
                      locked && a.drive.k_pe->options.hub.lock == solid::HubLock::kKeyway);
            EXPECT_EQ(words.find("EN AW-6082") != std::string::npos, body->name == "frame_plate");
        }
    }
}

// A hole of 4 mm with 1 mm on both sides, between the bore with its keyway and the floor.
TEST(Stops, ThePinIsPressedWhereThePulleyHasRoom) {
    const Drive& drive = shipped_joint("pnrvsa").assembly.drive;
    const auto with_joint = [&](double floor_mm) { return assemble(drive, 0.03, 1e-3 * (floor_mm + 0.4), {}).value(); };
    const double least = solid::bore_reach_mm(drive.k_pe->options.hub) + 6.0;
    const Assembly small = with_joint(least - 0.05), large = with_joint(least + 0.05);
    EXPECT_EQ(small.find("stop_pin"), nullptr);
    ASSERT_NE(large.find("stop_pin"), nullptr);
    const auto row = [](const Assembly& a, const char* item) {
        for (const BillRow& r : bill_of(a))
            if (r.item == item) return r.size + "; " + r.note;
        return std::string();
    };
    EXPECT_EQ(row(small, "stop pin"), "");
    EXPECT_NE(row(small, "stop post").find("the pulley's own pin is part of it"), std::string::npos);
    EXPECT_EQ(row(large, "stop pin"), "ISO 2338, 4 x 12 mm; pressed into the joint's pulley, down to its web");
    EXPECT_EQ(row(large, "stop post").find("part of it"), std::string::npos);
}

// Two posts that share volume make a tower that is no solid: where they would, there is one, which the pin meets at both ends.
TEST(Stops, NearlyAWholeTurnHasOnePost) {
    Layout layout;
    layout.joint = 16.0;
    layout.cable = 0.6;
    for (const double range : {1.0, 5.0, 5.3, 5.8, 6.2, 20.0}) {
        const std::vector<Eigen::Vector2d> places = stop_places(layout, range);
        ASSERT_EQ(places.size(), range < 5.5 ? 2U : 1U) << range;
        if (places.size() == 2)
            EXPECT_GT((places[0] - places[1]).norm(), 2.0 * kStop_mm) << range;
        else
            EXPECT_NEAR(places[0].x(), 0.0, 1e-9) << range;
    }
}

}  // namespace
}  // namespace fusee::assembly
