#include <gtest/gtest.h>

#include <algorithm>

#include "fixture.h"
#include "fusee/assembly/assembly.h"
#include "fusee/assembly/rule.h"
#include "fusee/core/change.h"
#include "fusee/spring/coil.h"

// What the torsion spring stands on, and what holds its legs.
namespace fusee::assembly {
namespace {

const Assembly& shipped() { return shipped_joint("pnrvsa").assembly; }

/// pnrvsa with another K_SE or another spring behind it.
Assembly changed(const std::function<void(solid::PartOptions&)>& part, const std::function<void(spring::BaseSpring&)>& spring = {}) {
    Drive drive = shipped().drive;
    solid::PartOptions options = drive.k_se->options;
    if (part) {
        part(options);
        drive.k_se = std::make_shared<solid::Part>(solid::build_part(drive.k_se->cam, options).value());
    }
    if (spring) spring(drive.k_se_spring);
    return assemble(drive, 0.03, 0.03, {}).value();
}

Assembly overhung(double rod_mm) {
    return changed(
        [](solid::PartOptions& options) {
            options.hub.kind = solid::HubKind::kOverhung, options.hub.lock = solid::HubLock::kPlain;
            options.hub.boss_diameter = 16e-3, options.hub.boss_height = 12e-3;
        },
        [=](spring::BaseSpring& s) { s.rod_diameter = core::m_from_mm(rod_mm); });
}

/// Findings of joint.spring_leg: that of the spool, then that of the carriage.
core::Findings legs(const Assembly& a) {
    core::Findings all = check(a, {});
    std::erase_if(all, [](const core::Finding& f) { return f.rule != "joint.spring_leg"; });
    return all;
}

solid::Box box_of(const Assembly& a, const char* body) { return solid::bounding_box(placed_mesh(a, *a.find(body), {})); }

bool in_bill(const Assembly& a, const std::string& item, const std::string& text) {
    const std::vector<BillRow> rows = bill_of(a);
    return std::any_of(rows.begin(), rows.end(), [&](const BillRow& row) {
        return row.item == item && (row.size + "; " + row.note).find(text) != std::string::npos;
    });
}

TEST(Arbor, IsASleeveTheAxleItselfOrTheAxleTurnedDown) {
    const auto with_rod = [](double mm) { return changed({}, [=](spring::BaseSpring& s) { s.rod_diameter = 1e-3 * mm; }); };
    const auto top_radius = [](const Assembly& a) { return a.find("axle_agonist")->shapes.back().radius_mm; };
    const Assembly sleeve = with_rod(7.0), bare = with_rod(0.0), neck = with_rod(5.0);
    ASSERT_NE(sleeve.find("spring_arbor_agonist"), nullptr);
    EXPECT_EQ(sleeve.find("spring_arbor_agonist")->shapes.front().radius_mm, 3.5);
    EXPECT_EQ(bare.find("spring_arbor_agonist"), nullptr);
    EXPECT_EQ(top_radius(bare), 3.0);
    EXPECT_EQ(top_radius(neck), 2.5);
    EXPECT_EQ(neck.find("axle_agonist")->shapes.front().radius_mm, 3.0) << "in sleeve and spool it keeps its diameter";
    EXPECT_TRUE(in_bill(sleeve, "spring arbor", "sleeve, 6 x 7 mm"));
    EXPECT_TRUE(in_bill(neck, "spool axle", "turned down to 5 mm over the upper"));
    EXPECT_TRUE(in_bill(neck, "retaining ring", "DIN 471, 5 x 0.6 mm"));
    EXPECT_FALSE(in_bill(bare, "spool axle", "turned down"));
}

/// Highest point of the mesh on the wall of its bore: the end of a blind one.
double bore_end_mm(const Assembly& a) {
    const solid::Part& part = *a.drive.k_se;
    double end = -INFINITY;
    for (const solid::Vec3& p : part.mesh.points_mm)
        if (std::hypot(p[0], p[1]) < 1.01 * 0.5e3 * (part.options.hub.bore_diameter + part.options.hub.bore_clearance))
            end = std::max(end, (a.find("k_se_agonist")->rest * Eigen::Vector3d(p[0], p[1], p[2])).z());
    return end;
}

TEST(Axle, OfAnOverhungSpoolEndsInItsBlindBore) {
    const Assembly a = overhung(0.0);
    EXPECT_NEAR(box_of(a, "axle_agonist").high_mm[2], bore_end_mm(a), 1e-6);
    EXPECT_LT(bore_end_mm(a), box_of(a, "k_se_agonist").high_mm[2] - 1.0) << "below the top face";
    EXPECT_EQ(a.find("axle_rings_agonist")->shapes.size(), 2U) << "a ring below, washers under the spool";
    EXPECT_TRUE(in_bill(a, "spool axle", "ends in the blind bore of k_se"));
    EXPECT_GT(box_of(shipped(), "axle_agonist").high_mm[2], box_of(shipped(), "k_se_agonist").high_mm[2]) << "a through axle";
}

TEST(Axle, OfAnOverhungSpoolLeavesTheArborToTheCarriage) {
    const Assembly without = overhung(0.0), with = overhung(6.0);
    EXPECT_GT(box_of(with, "carriage_agonist").high_mm[2], box_of(with, "k_se_spring_agonist").high_mm[2] + 3.0) << "the arm";
    EXPECT_LT(box_of(without, "carriage_agonist").high_mm[2], box_of(without, "k_se_spring_agonist").high_mm[2] + 3.0);
    const Extrusion& arbor = with.find("carriage_agonist")->shapes.at(8);
    EXPECT_EQ(arbor.radius_mm, 3.0);
    for (const core::Finding& f : check(with, {})) EXPECT_NE(f.severity, core::Severity::kError) << core::to_line(f);
}

TEST(Legs, OfAShippedJointAreHeld) {
    const core::Findings found = legs(shipped());
    ASSERT_EQ(found.size(), 2U);
    for (const core::Finding& f : found) EXPECT_EQ(f.severity, core::Severity::kPass) << core::to_line(f);
    EXPECT_NEAR(found[0].measured, 2.5, 1e-9) << "depth of the slot";
    EXPECT_NEAR(found[1].measured, 4.0, 1e-9) << "the post";
    EXPECT_NEAR(found[0].allowed, 1.1, 1e-9) << "a wire diameter";
}

TEST(Legs, WithoutAFittingSlotInTheSpoolAreNotHeld) {
    struct Bad {
        std::function<void(solid::FeatureOptions&)> spoil;
        const char* why;
    };
    for (const Bad& bad :
         {Bad{[](auto& f) { f.leg_slot_width = 0.0; }, "has no slot"}, Bad{[](auto& f) { f.leg_slot_width = 1e-3; }, "narrower"},
          Bad{[](auto& f) { f.leg_slot_radius = 6.4e-3; }, "misses it by 0.95 mm"},
          Bad{[](auto& f) { f.leg_slot_depth = 0.8e-3; }, "that the slot holds"}}) {
        Drive drive = shipped().drive;
        solid::Part part = *drive.k_se;
        bad.spoil(part.options.features);
        drive.k_se = std::make_shared<solid::Part>(part);
        const core::Findings found = legs(assemble(drive, 0.03, 0.03, {}).value());
        ASSERT_EQ(found.size(), 2U);
        EXPECT_EQ(found[0].severity, core::Severity::kWarning) << bad.why;
        EXPECT_NE(found[0].what.find(bad.why), std::string::npos) << found[0].what;
        EXPECT_EQ(found[1].severity, core::Severity::kPass);
    }
}

// The suggested slot, cut as it is stated, holds the leg.
TEST(Legs, ASuggestedSlotHoldsTheLeg) {
    const Assembly none = changed([](solid::PartOptions& options) { options.features.leg_slot_width = 0.0; });
    const core::Finding bad = legs(none).front();
    const auto changes = bad.suggestion.changes();
    ASSERT_EQ(changes.size(), 1U) << bad.suggestion.text();
    const Assembly cut = changed([&](solid::PartOptions& options) {
        for (const core::Change& change : changes.front()) {
            const double mm = std::stod(change.value);
            if (change.key.ends_with("width_mm")) options.features.leg_slot_width = 1e-3 * mm;
            if (change.key.ends_with("length_mm")) options.features.leg_slot_length = 1e-3 * mm;
            if (change.key.ends_with("depth_mm")) options.features.leg_slot_depth = 1e-3 * mm;
            if (change.key.ends_with("radius_mm")) options.features.leg_slot_radius = 1e-3 * mm;
        }
    });
    EXPECT_EQ(legs(cut).front().severity, core::Severity::kPass) << core::to_line(legs(cut).front());
}

// A spring that winds up by three turns more than the post was made for rises by three wires.
TEST(Legs, ThatRiseOutOfThePostAreNotHeld) {
    Assembly a = shipped();
    a.drive.k_se_spring.active_coils += 3.0;
    const core::Finding high = legs(a).back();
    EXPECT_EQ(high.severity, core::Severity::kWarning);
    EXPECT_NE(high.what.find("wound most it rises 2.75 mm out of the slot"), std::string::npos) << high.what;  // 3 x 1.1 less half a wire
    a.drive.k_se_spring.active_coils -= 6.0;
    EXPECT_NE(legs(a).back().what.find("below the slot's floor"), std::string::npos) << legs(a).back().what;
}

TEST(Legs, OfASpringWithoutItsSizesAreNotJudged) {
    const Assembly a = changed({}, [](spring::BaseSpring& s) { s.wire_diameter = 0.0; });
    ASSERT_EQ(legs(a).size(), 1U);
    EXPECT_EQ(legs(a).front().severity, core::Severity::kNotJudged);
}

// The post's slot begins below the leg as preloaded and ends above it as wound most: newcombspring.com, L = d (N + 1 + theta).
TEST(Legs, LieInThePostInEveryState) {
    for (const char* name : {"pnrvsa", "first_prototype", "paper/new_cams"}) {
        const Assembly& a = shipped_joint(name).assembly;
        const spring::BaseSpring& s = a.drive.k_se_spring;
        const double wire = 1e3 * s.wire_diameter, low = a.spring_low_mm;
        const auto top = [&](double state) { return low + wire * (s.active_coils + 1.0 + state / (2.0 * core::kPi)); };
        const double most = s.preload + a.drive.k_se->cam.working.back().arm.travel;
        EXPECT_LT(a.leg_slot.floor_mm, top(s.preload) - wire) << name;
        EXPECT_GT(a.leg_slot.top_mm, top(most)) << name;
        const solid::Box leg = box_of(a, "leg_in_carriage_agonist");
        EXPECT_NEAR(leg.high_mm[2] - a.plane_mm, top(most), 0.01) << name;
        EXPECT_NEAR(box_of(a, "leg_in_k_se_agonist").high_mm[2] - a.plane_mm, low, 1e-9) << name;
    }
}

/// Angle about the spool's axis of the middle of a leg, as its mesh stands in the joint [rad].
double leg_angle_of(const Assembly& a, const std::string& body) {
    const double side = body.ends_with("_antagonist") ? -1.0 : 1.0;
    Eigen::Vector2d sum(0.0, 0.0);
    for (const solid::Vec3& p : placed_mesh(a, *a.find(body), {}).points_mm)
        sum += Eigen::Vector2d(p[0] - side * a.spool_axis_mm.x(), p[1] - a.spool_axis_mm.y());
    return std::atan2(sum.y(), sum.x());
}

core::Finding phase(const Assembly& a) {
    for (const core::Finding& f : check(a, {}))
        if (f.rule == "joint.leg_phase") return f;
    return {};
}

// The coils of a left-hand spring rise clockwise: its upper leg stands 2 pi n + preload behind the lower one. Its mirror image is
// right-hand.
TEST(Phase, OfBothLegsIsThatOfCoilsAndPreload) {
    for (const char* name : {"pnrvsa", "first_prototype", "paper/new_cams"}) {
        const Assembly& a = shipped_joint(name).assembly;
        const spring::BaseSpring& s = a.drive.k_se_spring;
        ASSERT_EQ(s.hand, spring::Hand::kLeft);
        for (const auto& [side, sense] : {std::pair("_agonist", -1.0), std::pair("_antagonist", 1.0)}) {
            const double apart =
                leg_angle_of(a, std::string("leg_in_carriage") + side) - leg_angle_of(a, std::string("leg_in_k_se") + side);
            EXPECT_NEAR(std::remainder(apart - sense * (2.0 * core::kPi * s.active_coils + s.preload), 2.0 * core::kPi), 0.0, 0.01)
                << name << side;
        }
        EXPECT_EQ(phase(a).severity, core::Severity::kPass) << core::to_line(phase(a));
        EXPECT_NEAR(phase(a).measured, 0.0, 1e-6) << name;
    }
}

TEST(Phase, OfASpringWithAQuarterOfATurnMoreIsAnError) {
    Assembly a = shipped();
    a.drive.k_se_spring.active_coils += 0.25;
    EXPECT_EQ(phase(a).severity, core::Severity::kError);
    EXPECT_NEAR(phase(a).measured, 90.0, 1e-6);
    const Assembly its_own = changed({}, [](spring::BaseSpring& s) { s.active_coils += 0.25; });
    EXPECT_EQ(phase(its_own).severity, core::Severity::kPass) << "its post stands elsewhere: " << core::to_line(phase(its_own));
}

// With its slot opposite the key the radial leg of pnrvsa would stand at 58 deg, where the series cable leaves the spool.
TEST(Phase, APostInTheWayOfTheCableAsksForAnotherSlot) {
    const auto with_slot = [](double deg) {
        return changed([=](solid::PartOptions& options) { options.features.leg_slot_angle = core::rad_from_deg(deg); });
    };
    const core::Finding bad = phase(with_slot(180.0));
    EXPECT_EQ(bad.severity, core::Severity::kError);
    EXPECT_NE(bad.what.find("the preload leave it at 58 deg"), std::string::npos) << bad.what;
    const auto changes = bad.suggestion.changes();
    ASSERT_EQ(changes.size(), 1U);
    EXPECT_EQ(changes.front().front().key, "k_se.features.leg_slot_angle_deg");
    const Assembly turned = with_slot(std::stod(changes.front().front().value));
    for (const core::Finding& f : check(turned, {})) EXPECT_NE(f.severity, core::Severity::kError) << core::to_line(f);
}

}  // namespace
}  // namespace fusee::assembly
