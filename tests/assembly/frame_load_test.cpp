#include <gtest/gtest.h>

#include <algorithm>

#include "fixture.h"
#include "fusee/assembly/rule.h"
#include "layout.h"

// What the cables do to the frame: statics by hand from the bodies' own boxes.
namespace fusee::assembly {
namespace {

const Assembly& framed() { return shipped_joint("pnrvsa").assembly; }

/// pnrvsa with `times` its tensions.
Assembly pulled(double times) {
    Assembly a = framed();
    for (auto* part : {&a.drive.k_se, &a.drive.k_pe}) {
        solid::Part other = **part;
        for (cam::Contact& c : other.cam.working) c.arm.tension *= times;
        *part = std::make_shared<solid::Part>(other);
    }
    return a;
}

core::Finding worst(const Assembly& a, const std::string& rule) {
    const core::Findings all = judged_by(rule, a);
    return *std::max_element(all.begin(), all.end(),
                             [](const core::Finding& p, const core::Finding& q) { return p.severity < q.severity; });
}

double middle_mm(const Extrusion& ring) { return ring.frame.translation().z() + 0.5 * ring.length_mm; }

// Both series cables pull at the pulley with 2 T; tower and plate hold its shaft above it: sums of forces, moments about the plate.
TEST(FrameLoads, OfTheJointsShaftAreThoseOfALever) {
    const Assembly& a = framed();
    const auto& rings = a.find("bearings")->shapes;
    const double tower = middle_mm(rings[0]), plate = middle_mm(rings[1]), pull = 2.0 * tensions(a.drive.k_se->cam)[1];
    const FrameLoad load = frame_load(a).value();
    EXPECT_NEAR(load.bearings[2].force, pull * plate / (plate - tower), 1e-9);
    EXPECT_NEAR(load.bearings[3].force, pull * tower / (plate - tower), 1e-9);
    const ShaftLoad shaft = joint_shaft_load(a);
    EXPECT_NEAR(shaft.moment, 1e-3 * pull * tower, 1e-9) << "the middle of both cables is the origin";
    EXPECT_EQ(shaft.torque, 0.0) << "the output link is screwed to the pulley";
}

// The motor's shaft: K_PE pulls below the arm, the drive cable between arm and plate, against each other.
TEST(FrameLoads, OfAMotorsShaftAreThoseOfALever) {
    const Assembly& a = framed();
    const auto& rings = a.find("bearings")->shapes;
    const FrameLoad load = frame_load(a).value();
    double near = 0.0;
    for (const bool agonist : {true, false}) {
        const double arm = middle_mm(rings[agonist ? 2 : 4]), plate = middle_mm(rings[agonist ? 3 : 5]);
        const double cam = a.find(agonist ? "k_pe_agonist" : "k_pe_antagonist")->rest.translation().z();  // planar: the cable's height
        const double drive = agonist ? a.plane_mm : -a.plane_mm;
        const double k_pe = tensions(a.drive.k_pe->cam)[1], series = tensions(a.drive.k_se->cam)[0];
        near = std::max(near, (k_pe * (plate - cam) - series * (plate - drive)) / (plate - arm));
    }
    EXPECT_NEAR(load.bearings[0].force, near, 0.01 * near);
}

// A post is a cantilever below the plate: 6 F h/(b t^2); its far screw carries M l/(l1^2 + l2^2).
TEST(FrameLoads, OfAPostAreThoseOfACantilever) {
    const Assembly& a = framed();
    const double face = a.find("frame_plate")->shapes.front().frame.translation().z(), force = tensions(a.drive.k_pe->cam)[1];
    const Extrusion& seat = a.find("k_pe_seat_antagonist")->shapes.front();
    const double moment = 1e-3 * force * (face - (a.find("k_pe_seat_antagonist")->rest * seat.frame).translation().z());
    const FrameLoad load = frame_load(a).value();
    const FrameLoad::Part& post = load.parts[3];
    EXPECT_STREQ(post.name, "k_pe_posts");
    EXPECT_NEAR(post.stress_MPa, 1e-6 * 6.0 * moment / (2e-3 * seat.half_x_mm * 24e-3 * 24e-3), 1e-6);
    EXPECT_NEAR(post.screw, moment * 19.2e-3 / (19.2e-3 * 19.2e-3 + 4.8e-3 * 4.8e-3), 1e-6);
}

/// pnrvsa whose plate is a rectangle 100 mm wide without holes.
Assembly with_plain_plate(double thick_mm) {
    Assembly a = framed();
    a.frame_holes.clear();
    for (Body& body : a.bodies)
        if (body.name == "frame_plate") {
            body.shapes.front().outline = {{{-50.0, -600.0}, 0.0}, {{50.0, -600.0}, 0.0}, {{50.0, 100.0}, 0.0}, {{-50.0, 100.0}, 0.0}};
            body.shapes.front().length_mm = thick_mm;
        }
    return a;
}

// Both springs K_PE push their posts away from the motors, far below the plate: it bends between them, more than by the series cables.
TEST(FrameLoads, OfThePlateAreThoseOfABeamUnderBothKPe) {
    const Assembly a = with_plain_plate(10.0);
    const double face = a.find("frame_plate")->shapes.front().frame.translation().z(), pull = 2.0 * tensions(a.drive.k_pe->cam)[1];
    const double cables =
        0.5 * ((a.find("k_pe_seat_agonist")->rest * a.find("k_pe_seat_agonist")->shapes.front().frame).translation().z() +
               (a.find("k_pe_seat_antagonist")->rest * a.find("k_pe_seat_antagonist")->shapes.front().frame).translation().z());
    const FrameLoad load = frame_load(a).value();
    const FrameLoad::Part& plate = load.parts.back();
    EXPECT_STREQ(plate.name, "frame_plate");
    EXPECT_STREQ(plate.material.name, "aluminium");
    EXPECT_NEAR(plate.stress_MPa, 1e-6 * (6.0 * pull * 1e-3 * (face + 5.0 - cables) / (0.1 * 1e-4) + pull / (0.1 * 1e-2)), 1e-6);
}

// The plate as a beam of constant section; the rest by a unit load on each lever.
TEST(FrameGives, AreThoseOfBeams) {
    const Assembly a = with_plain_plate(10.0);
    const std::vector<FrameGive> gives = frame_gives(a);
    ASSERT_EQ(gives.size(), 2U);
    const double face = 1e-3 * a.find("frame_plate")->shapes.front().frame.translation().z(), plate = 70e9 * 0.1 * 1e-6 / 12.0;
    const double rear = 1e-3 * a.find("frame_rear")->shapes.front().frame.translation().y();
    EXPECT_NEAR(gives[0].plate / (2.0 * std::pow(face + 5e-3, 2) * -rear / plate), 1.0, 1e-9);
    const double cables = 1e-3 * (a.k_pe_guide_mm.z() - a.plane_mm), post_y = 1e-3 * (a.k_pe_guide_mm.y() + 12.0);
    EXPECT_NEAR(gives[1].plate / (2.0 * std::pow(face + 5e-3 - cables, 2) * (rear - post_y) / plate), 1.0, 1e-9);

    constexpr double kPla = 2.3e9, kSteel = 210e9;
    const double shaft = kSteel * core::kPi * std::pow(6e-3, 4) / 64.0;
    const auto& rings = a.find("bearings")->shapes;  // the antagonist's cables are lower
    const double near = 1e-3 * middle_mm(rings[4]), far = 1e-3 * middle_mm(rings[5]), k_pe = cables - 1e-3 * a.plane_mm, out = near - k_pe;
    const double arm =
        std::pow(face - near, 3) / (3.0 * kPla * 1e-3 * rear_width_mm(a, 1e3 * (face - near)) * std::pow(1e-3 * kBracket_mm, 3) / 12.0);
    const double depth = face - k_pe, post = std::pow(depth, 3) / (3.0 * kPla * 2e-3 * seat_half_mm(a.drive) * std::pow(24e-3, 3) / 12.0);
    EXPECT_NEAR((gives[1].whole - gives[1].plate) /
                    (std::pow((far - k_pe) / (far - near), 2) * arm + out * out * (out + far - near) / (3.0 * shaft) + post),
                1.0, 1e-9);
    EXPECT_DOUBLE_EQ(gives[1].rate, 7460.0);
}

TEST(FrameGives, AreJudged) {
    for (const char* name : {"pnrvsa", "free_curve", "paper/new_cams", "first_prototype"})
        EXPECT_EQ(worst(shipped_joint(name).assembly, "joint.frame_stiffness").severity, core::Severity::kPass)
            << name << core::to_line(worst(shipped_joint(name).assembly, "joint.frame_stiffness"));
    Assembly thin = framed();
    for (Body& body : thin.bodies)
        if (body.name == "frame_plate") body.shapes.front().length_mm = 4.0;
    const core::Finding gives_way = worst(thin, "joint.frame_stiffness");
    EXPECT_EQ(gives_way.severity, core::Severity::kWarning) << core::to_line(gives_way);
    EXPECT_NE(gives_way.suggestion.text().find("assembly.wall_mm"), std::string::npos) << gives_way.suggestion.text();
}

TEST(FrameLoads, AreJudged) {
    for (const char* rule : {"joint.frame_strength", "joint.frame_screws", "joint.bearing_load"}) {
        for (const char* name : {"pnrvsa", "free_curve", "paper/new_cams", "first_prototype"})
            EXPECT_EQ(worst(shipped_joint(name).assembly, rule).severity, core::Severity::kPass)
                << name << core::to_line(worst(shipped_joint(name).assembly, rule));
        EXPECT_EQ(worst(pulled(10.0), rule).severity, core::Severity::kError) << core::to_line(worst(pulled(10.0), rule));
    }
    const core::Finding dented = worst(pulled(10.0), "joint.bearing_load");
    EXPECT_NE(dented.suggestion.text().find("k_pe.hub.bore_mm"), std::string::npos) << dented.suggestion.text();
}

TEST(FrameLoads, NothingIsJudgedWithoutAFrame) {
    const Assembly bare = assemble(framed().drive, 0.03, 0.03, {.frame = false}).value();
    EXPECT_FALSE(frame_load(bare));
    for (const char* rule : {"joint.frame_strength", "joint.frame_screws", "joint.frame_stiffness", "joint.bearing_load"})
        EXPECT_TRUE(judged_by(rule, bare).empty());
}

}  // namespace
}  // namespace fusee::assembly
