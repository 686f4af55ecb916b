#include <gtest/gtest.h>

#include <cmath>

#include "fusee/exchange/brep.h"
#include "solid/fixture.h"

namespace fusee::exchange::brep {
namespace {

using solid::HubKind;
using solid::HubLock;
using solid::PartOptions;

solid::Part made(const cam::Cam& cam, const PartOptions& options) {
    auto part = solid::build_part(cam, options);
    if (!part) throw std::runtime_error(core::to_line(part.refusal().front()));
    return std::move(part).value();
}

/// Radius of a disc of pitch radius R at height z [mm]: the groove's arc, its flanks, the flange. From the options alone.
double radius_at(double pitch_mm, double cable_mm, const solid::GrooveOptions& groove, double z) {
    const double r = groove.radius_ratio * cable_mm, half = 0.5 * groove.throat, floor = pitch_mm - 0.5 * cable_mm;
    const double depth = groove.depth_ratio * cable_mm, arc = r * std::cos(half), at = std::abs(z);
    if (at < arc) return floor + r - std::sqrt(r * r - at * at);
    return floor + std::min(depth, r * (1.0 - std::sin(half)) + (at - arc) / std::tan(half));
}

// Known answer: pi times the integral of R(z)^2 less the bore's cylinder.
TEST(Build, ADiscHasItsVolume) {
    const PartOptions options = solid::test::plain();
    const solid::Part part = made(solid::test::disc(0.012), options);
    const auto brep = build(part);
    ASSERT_TRUE(brep) << core::to_line(brep.refusal().front());
    const double low = core::mm_from_m(part.z_low), high = core::mm_from_m(part.z_high);
    const double bore = core::mm_from_m(0.5 * (options.hub.bore_diameter + options.hub.bore_clearance));
    double volume = 0.0;
    constexpr int kSlices = 200000;
    for (int i = 0; i < kSlices; ++i) {
        const double r = radius_at(12.0, 0.8, options.groove, low + (high - low) * (i + 0.5) / kSlices);
        volume += core::kPi * (r * r - bore * bore) * (high - low) / kSlices;
    }
    EXPECT_NEAR(brep->volume_mm3 / volume, 1.0, 2e-5);  // splines within 0.2 um of 12 mm, both ways
    EXPECT_LE(brep->deviation_mm, 2e-4);
}

struct Shape {
    const char* name;
    cam::Cam cam;
    PartOptions options;
};
void PrintTo(const Shape& shape, std::ostream* out) { *out << shape.name; }

PartOptions featured() {
    PartOptions o;
    o.features.leg_slot_width = 1.2e-3;
    o.features.leg_slot_length = 2e-3;
    o.features.leg_slot_radius = 7e-3;
    o.features.leg_slot_depth = 1e-3;
    return o;
}
PartOptions overhung() {
    PartOptions o;
    o.hub.kind = HubKind::kOverhung;
    o.hub.lock = HubLock::kSetScrew;
    o.hub.screw_diameter = 2e-3;
    o.hub.boss_diameter = 12e-3;
    o.hub.boss_height = 6e-3;
    return o;
}
PartOptions flat() {
    PartOptions o;
    o.hub.lock = HubLock::kDFlat;
    o.flange_height = 1e-3;
    return o;
}

class Shapes : public testing::TestWithParam<Shape> {};
INSTANTIATE_TEST_SUITE_P(Brep, Shapes,
                         testing::Values(Shape{"disc", solid::test::disc(), featured()},
                                         Shape{"eccentric", solid::test::disc(0.014, 0.004), flat()},
                                         Shape{"overhung", solid::test::disc(0.009, 0.003), overhung()},
                                         Shape{"half_a_turn", solid::test::snail(0.5, 3e-3, 2e-3), PartOptions{}},
                                         Shape{"one_and_a_half_turns", solid::test::snail(1.5, 4e-3, 2e-3), PartOptions{}},
                                         Shape{"two_and_a_half_turns", solid::test::snail(2.5, 4e-3, 2e-3), PartOptions{}}),
                         [](const auto& one) { return std::string(one.param.name); });

TEST_P(Shapes, AreOneSolidOfFewFacesWithTheMeshsVolume) {
    const solid::Part part = made(GetParam().cam, GetParam().options);
    const auto brep = build(part);
    ASSERT_TRUE(brep) << core::to_line(brep.refusal().front());
    EXPECT_LE(brep->faces, 50U);
    EXPECT_LE(brep->deviation_mm, 1e-3);
    EXPECT_NEAR(brep->volume_mm3 / solid::volume_mm3(part.mesh), 1.0, 5e-4);
}

// Known answer: chords of sagitta e take 4/3 e/R of a disc's area, 0.17 % for 15 um at 12 mm: half of the chordal error is along the path.
TEST(Build, RefusesAMeshTooCoarseForItAndSaysHowFineItHasToBe) {
    PartOptions options = solid::test::plain();
    options.chordal_error = 30e-6;
    const auto coarse = build(made(solid::test::disc(0.012), options));
    ASSERT_FALSE(coarse);
    const core::Finding& f = coarse.refusal().front();
    EXPECT_EQ(f.rule, "brep.validity");
    EXPECT_NEAR(f.measured, 0.17, 0.08);  // [%]
    EXPECT_EQ(f.allowed, 0.05);
    const std::string key = "tolerances.chordal_error_mm = ";
    ASSERT_TRUE(f.suggestion.text().starts_with(key)) << f.suggestion.text();
    options.chordal_error = core::m_from_mm(std::stod(f.suggestion.text().substr(key.size())));
    EXPECT_TRUE(build(made(solid::test::disc(0.012), options)));
}

TEST(Build, RefusesWhatIsNotTheMeshsBody) {
    solid::Part part = made(solid::test::disc(), solid::test::plain());
    for (solid::Vec3& p : part.mesh.points_mm) p[2] *= 1.001;
    const auto brep = build(part);
    ASSERT_FALSE(brep);
    EXPECT_EQ(brep.refusal().front().rule, "brep.validity");
    EXPECT_NEAR(brep.refusal().front().measured, 0.1, 0.02);  // [%]
}

}  // namespace
}  // namespace fusee::exchange::brep
