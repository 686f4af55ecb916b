#include "fusee/solid/part.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

#include "fixture.h"
#include "fusee/core/error.h"
#include "fusee/solid/validity.h"

namespace fusee::solid {
namespace {

using namespace test;

// Known (Pappus): a turned disc with a groove has pi (R_lip^2 - R_bore^2) H less 2 pi x groove area x its centroid's radius; both integrals
// are taken over the section's own polygon, so only the sweep's chords remain: relative loss (2/3) sin^2 < 1e-3 at 0.12 rad columns.
TEST(Part, DiscHasItsVolume) {
    PartOptions o = plain();
    o.chordal_error = 0.2e-6;
    const Part part = build_part(disc(), o).value();
    const double radius = 12.0, lip = part.section.front().offset_mm + radius, height = 1e3 * (part.z_high - part.z_low), bore = 2.6;
    double moment = 0.0;  // integral over the groove of 2 pi r dr dz = pi (R_lip^2 - r^2) dz
    for (std::size_t i = 1; i < part.section.size(); ++i) {
        const double r0 = radius + part.section[i - 1].offset_mm, r1 = radius + part.section[i].offset_mm;
        moment += core::kPi * (lip * lip - (r0 * r0 + r0 * r1 + r1 * r1) / 3.0) * (part.section[i].z_mm - part.section[i - 1].z_mm);
    }
    const double expected = core::kPi * (lip * lip - bore * bore) * height - moment;
    EXPECT_NEAR(volume_mm3(part.mesh), expected, 1e-4 * expected);
    EXPECT_LT(volume_mm3(part.mesh), expected);  // inscribed outside, and the bore is small
}

// Known: every vertex of the groove lies on the analytic surface, every triangle within the stated chordal error of it. For a disc about
// (e, 0) the surface is turned: distance in the half-plane through the disc's own axis.
TEST(Part, GrooveStaysWithinTheStatedChordalError) {
    PartOptions o = plain();
    const double e = 3.0, radius = 12.0, cable = 0.8, floor_radius = 0.53 * cable;
    const Part part = build_part(disc(0.012, 0.003), o).value();
    double worst = 0.0;
    std::size_t tested = 0;
    for (const Triangle& t : part.mesh.triangles) {
        Vec3 centre{};
        bool on_floor = true;
        for (const std::uint32_t v : t) {
            const Vec3& p = part.mesh.points_mm[v];
            const double from_arc = std::hypot(std::hypot(p[0] - e, p[1]) - radius + cable / 2.0 - floor_radius, p[2]) - floor_radius;
            on_floor = on_floor && std::abs(from_arc) < 2e-6;  // single precision
            for (std::size_t i = 0; i < 3; ++i) centre[i] += p[i] / 3.0;
        }
        if (!on_floor) continue;
        ++tested;
        const double distance =
            std::hypot(std::hypot(centre[0] - e, centre[1]) - radius + cable / 2.0 - floor_radius, centre[2]) - floor_radius;
        worst = std::max(worst, std::abs(distance));
    }
    EXPECT_GT(tested, 1000u);
    EXPECT_LE(worst, part.chordal_error_mm);
    EXPECT_GT(worst, 0.05 * part.chordal_error_mm);  // and it is not bought with needless triangles
}

struct HubCase {
    const char* name;
    HubKind kind;
    HubLock lock;
    int through_holes;  // genus
};
void PrintTo(const HubCase& c, std::ostream* out) { *out << c.name; }
class EveryHub : public ::testing::TestWithParam<HubCase> {};

TEST_P(EveryHub, IsAValidSolidOfTheRightGenus) {
    PartOptions o;
    o.hub.kind = GetParam().kind;
    o.hub.lock = GetParam().lock;
    o.hub.bore_diameter = 5e-3;
    if (o.hub.kind == HubKind::kOverhung || o.hub.lock == HubLock::kSetScrew) {
        o.hub.boss_diameter = 14e-3;
        o.hub.boss_height = 8e-3;
        o.hub.screw_diameter = 3e-3;
    }
    o.features.leg_slot_width = 1.2e-3;
    o.features.leg_slot_length = 2.4e-3;
    o.features.leg_slot_radius = 7e-3;
    o.features.leg_slot_depth = 1.5e-3;
    const auto part = build_part(disc(), o);
    ASSERT_TRUE(part) << core::to_line(part.refusal().front());
    EXPECT_TRUE(validate(part->mesh).good()) << validate(part->mesh).line();
    EXPECT_EQ(measure_quality(part->mesh).euler, 2 - 2 * GetParam().through_holes);
    EXPECT_EQ(measure_quality(part->mesh).boundary_edges, 0u);
}

// The anchor hole joins groove and top face: one handle. A through bore is another, a set screw's hole into it one more.
INSTANTIATE_TEST_SUITE_P(Hubs, EveryHub,
                         ::testing::Values(HubCase{"through_plain", HubKind::kThrough, HubLock::kPlain, 2},
                                           HubCase{"through_keyway", HubKind::kThrough, HubLock::kKeyway, 2},
                                           HubCase{"through_d_flat", HubKind::kThrough, HubLock::kDFlat, 2},
                                           HubCase{"through_set_screw", HubKind::kThrough, HubLock::kSetScrew, 3},
                                           HubCase{"overhung_keyway", HubKind::kOverhung, HubLock::kKeyway, 1},
                                           HubCase{"overhung_d_flat", HubKind::kOverhung, HubLock::kDFlat, 1},
                                           HubCase{"overhung_set_screw", HubKind::kOverhung, HubLock::kSetScrew, 2}),
                         [](const auto& instance) { return std::string(instance.param.name); });

class EverySnail : public ::testing::TestWithParam<double> {};

TEST_P(EverySnail, IsAValidSolidWithAMatchingSkin) {
    const auto part = build_part(snail(GetParam(), 4.5e-3, 2e-3), PartOptions{});
    ASSERT_TRUE(part) << core::to_line(part.refusal().front());
    EXPECT_TRUE(validate(part->mesh).good()) << validate(part->mesh).line();
    EXPECT_TRUE(validate(part->skin).good()) << validate(part->skin).line();
    EXPECT_GT(volume_mm3(part->skin), volume_mm3(part->mesh));
    const Box box = bounding_box(part->mesh), skin = bounding_box(part->skin);
    EXPECT_NEAR(box.low_mm[2], skin.low_mm[2], 1e-6);  // single precision
    EXPECT_NEAR(box.high_mm[2], skin.high_mm[2], 1e-6);
}
INSTANTIATE_TEST_SUITE_P(Turns, EverySnail, ::testing::Values(0.4, 0.95, 1.43, 2.2, 3.6));

TEST(Part, FlangesStandAboveTheLips) {
    PartOptions o = plain();
    o.flange_height = 2e-3;
    const Part part = build_part(disc(), o).value();
    EXPECT_NEAR(bounding_box(part.mesh).high_mm[0], 12.0 + part.section.front().offset_mm + 2.0, 1e-6);  // single precision
    EXPECT_TRUE(validate(part.mesh).good());
}

TEST(Part, SameInputGivesTheSameMesh) {
    const Part first = build_part(snail(1.43, 4.5e-3, 2e-3), {}).value(), second = build_part(snail(1.43, 4.5e-3, 2e-3), {}).value();
    EXPECT_EQ(first.mesh.points_mm, second.mesh.points_mm);
    EXPECT_EQ(first.mesh.triangles, second.mesh.triangles);
}

// Cuts that were proven before are not made again: a tool moved by a micrometre is another one.
TEST(Part, AnotherToolOnTheSameBodyIsCutAnew) {
    PartOptions wide = plain();
    wide.features.mark_width = 1e-3, wide.features.mark_depth = 0.3e-3;
    PartOptions wider = wide;
    wider.features.mark_width += 1e-6;
    const Part first = build_part(disc(), wide).value(), other = build_part(disc(), wider).value(),
               again = build_part(disc(), wide).value();
    EXPECT_EQ(first.mesh.points_mm, again.mesh.points_mm);
    EXPECT_NE(first.mesh.points_mm, other.mesh.points_mm);
    EXPECT_LT(volume_mm3(other.mesh), volume_mm3(first.mesh));
}

TEST(Part, RefusesWithTheBindingLimit) {
    PartOptions wide = plain();
    wide.hub.bore_diameter = 24e-3;
    const auto bored = build_part(disc(), wide);
    ASSERT_FALSE(bored);
    EXPECT_EQ(bored.refusal().front().rule, "solid.bore");
    const auto thick = build_part(disc(3.9e-3, 0.0, 8e-3), plain());
    ASSERT_FALSE(thick);
    EXPECT_EQ(thick.refusal().front().rule, "solid.floor");
    PartOptions below = plain();
    below.hub.kind = HubKind::kOverhung;
    below.hub.boss_diameter = 16e-3;
    below.hub.boss_height = 12e-3;
    const auto beside = build_part(disc(12e-3, 14e-3), below);  // the axis is 2 mm outside the disc
    ASSERT_FALSE(beside);
    EXPECT_EQ(beside.refusal().front().rule, "solid.axis");
    PartOptions anchored = plain();
    anchored.features.anchor_hole_diameter = 30e-3;
    const auto holed = build_part(disc(), anchored);
    ASSERT_FALSE(holed);
    EXPECT_EQ(holed.refusal().front().rule, "solid.anchor");
    const auto crowded = build_part(snail(1.5, 2e-3, 1e-3), plain());
    ASSERT_FALSE(crowded);
    EXPECT_EQ(crowded.refusal().front().rule, "solid.turns");
    EXPECT_NE(crowded.refusal().front().suggestion.text().find("k_pe.path.pitch_mm"), std::string::npos);
}

TEST(Part, NamesTheBadOption) {
    const auto expect_refused = [](const PartOptions& o, const std::string& field) {
        try {
            (void)build_part(disc(), o);
            FAIL() << field << " was accepted";
        } catch (const core::InvalidInput& e) {
            EXPECT_EQ(e.field(), field);
        }
    };
    PartOptions wide_key;
    wide_key.hub.key_width = 10e-3;
    expect_refused(wide_key, "k_se.hub.key_width_mm");
    PartOptions boss;
    boss.hub.boss_height = 1e-3;
    for (const double diameter : {0.0, 5e-3}) {  // none, and one within the bore
        boss.hub.boss_diameter = diameter;
        expect_refused(boss, "k_se.hub.boss_mm");
    }
}

}  // namespace
}  // namespace fusee::solid
