#include "fusee/coupon/bodies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fusee/solid/validity.h"
#include "refused.h"

namespace fusee::coupon {
namespace {

/// Coarser than a profile's, so that Booleans take little.
CouponOptions coarse(double bore = 6e-3) {
    CouponOptions options;
    options.hub.bore_diameter = bore;
    options.hub.key_width = bore / 3.0;
    options.hub.key_depth = bore / 6.0;
    options.cable_diameter = 0.8e-3;
    options.chordal_error = 20e-6;
    return options;
}

TEST(Plate, IsOneSolidOfTheVolumeDrawn) {
    for (const double bore : {2e-3, 6e-3, 20e-3}) {
        const CouponOptions options = coarse(bore);
        const auto plate = make_plate(options);
        ASSERT_TRUE(plate);
        EXPECT_TRUE(solid::validate(plate->mesh).good()) << solid::validate(plate->mesh).line();
        const solid::Box box = solid::bounding_box(plate->mesh);
        EXPECT_NEAR(box.high_mm[0] - box.low_mm[0], plate->length_mm, 1e-5) << "STL's single precision";
        EXPECT_NEAR(box.high_mm[1] - box.low_mm[1], plate->length_mm, 1e-5);
        EXPECT_NEAR(box.high_mm[2] - box.low_mm[2], plate->tower_mm, 1e-5);
        const double l = plate->length_mm, w = plate->width_mm, t = plate->plate_mm, wall = 3.0;
        double volume = (2.0 * l * w - w * w) * t + std::pow(w - 2.0, 2) * (plate->tower_mm - t);
        for (const double d : plate->bores_mm) volume -= 0.25 * core::kPi * d * d * t;
        volume -= 10 * 0.8 * 0.75 * wall * 0.6;  // 0 + 1 + 2 + 3 + 4 notches, 0.8 mm wide, three quarters of a wall long, 0.6 mm deep
        // A hole's polygon keeps within 0.02 mm of its circle: at most that over its circumference, two thirds of it on the mean.
        double chords = 0.0;
        for (const double d : plate->bores_mm) chords += core::kPi * d * 0.02 * t;
        EXPECT_NEAR(solid::volume_mm3(plate->mesh), volume, chords);
        EXPECT_EQ(plate->bores_mm.size(), 5u);
        EXPECT_NEAR(plate->bores_mm.front(), 1e3 * bore, 1e-9);
        EXPECT_NEAR(plate->bores_mm.back(), 1e3 * bore + 0.4, 1e-9);
    }
}

/// Radius of the mesh's points at a height, the innermost outside of the bore.
double floor_at(const solid::Mesh& mesh, double z_mm, double bore_radius) {
    double least = 1e9;
    for (const solid::Vec3& p : mesh.points_mm)
        if (const double r = std::hypot(p[0], p[1]); std::abs(p[2] - z_mm) < 1e-4 && r > bore_radius + 0.1) least = std::min(least, r);
    return least;
}

TEST(GrooveLadder, HasEveryGrooveOnTheSameFloorAndTheProfilesOwnAmongThem) {
    CouponOptions options = coarse();
    options.groove.radius_ratio = 0.58;
    const auto ladder = make_groove_ladder(options);
    ASSERT_TRUE(ladder);
    EXPECT_TRUE(solid::validate(ladder->mesh).good()) << solid::validate(ladder->mesh).line();
    EXPECT_TRUE(std::is_sorted(ladder->ratios.begin(), ladder->ratios.end()));
    EXPECT_NE(std::find(ladder->ratios.begin(), ladder->ratios.end(), 0.58), ladder->ratios.end());
    ASSERT_EQ(ladder->z_mm.size(), ladder->ratios.size());
    for (const double z : ladder->z_mm) EXPECT_NEAR(floor_at(ladder->mesh, z, 3.2), floor_mm(options), 1e-5) << z;
    for (const double throat : {0.0, core::rad_from_deg(150.0)}) {  // depth of the profile below the widest floor's, and far above
        options.groove.throat = throat;
        options.groove.depth_ratio = 0.6;
        EXPECT_TRUE(make_groove_ladder(options)) << throat;
    }
}

/// Closed form: a linear law on a linear spring has one arm, R + d/2, and draws in 2 pi (R + d/2) a turn.
TEST(Disc, HasOneArmEverywhere) {
    const CouponOptions options = coarse();
    const auto disc = make_disc(options);
    ASSERT_TRUE(disc);
    EXPECT_TRUE(solid::validate(disc->part.mesh).good());
    const double arm = 1e-3 * (floor_mm(options) + 0.4);
    const auto& working = disc->part.cam.working;
    for (const cam::Contact& c : working) {
        EXPECT_NEAR(c.arm.arm, arm, 1e-12);
        EXPECT_NEAR(c.path.h, arm, 1e-12);
        EXPECT_NEAR(c.path.rho, arm, 1e-9);
    }
    EXPECT_GT(disc->part.cam.anchor_psi, disc->part.cam.working_psi.high) << "the anchor hole goes up and meets no turn";
    EXPECT_NEAR(working.back().arm.angle, 2.0 * core::kPi * 3.0, 1e-6);
    const double drawn_in = working.back().arm.state - working.front().arm.state;  // of the spring's cable
    EXPECT_NEAR(drawn_in, 2.0 * core::kPi * 3.0 * arm, 1e-8);
}

TEST(Disc, TakesEveryHub) {
    CouponOptions options = coarse();
    for (const auto lock : {solid::HubLock::kPlain, solid::HubLock::kKeyway, solid::HubLock::kDFlat, solid::HubLock::kSetScrew}) {
        options.hub.lock = lock;
        options.hub.boss_diameter = 14e-3;
        options.hub.boss_height = 8e-3;
        options.hub.screw_diameter = 2.5e-3;
        EXPECT_TRUE(make_disc(options)) << static_cast<int>(lock);
    }
    options = coarse();
    options.hub.kind = solid::HubKind::kOverhung;
    options.hub.boss_height = 8e-3;
    options.hub.boss_diameter = 14e-3;
    EXPECT_TRUE(make_disc(options)) << "an overhung part's shaft goes through the disc";
}

TEST(Coupons, RefuseByTheKeyThatIsWrong) {
    CouponOptions options = coarse();
    options.hub.bore_diameter = 0.0;
    EXPECT_EQ(field_refused([&] { return make_plate(options); }), "k_se.hub.bore_mm");
    options = coarse();
    options.groove.radius_ratio = 0.4;
    EXPECT_EQ(field_refused([&] { return make_groove_ladder(options); }), "groove.radius_ratio");
    options = coarse();
    options.disc_turns = 20.0;
    EXPECT_EQ(field_refused([&] { return make_disc(options); }), "disc_turns");
}

TEST(Coupons, SameMeshTwice) {
    EXPECT_EQ(make_plate(coarse())->mesh.points_mm, make_plate(coarse())->mesh.points_mm);
    EXPECT_EQ(make_disc(coarse())->part.mesh.triangles, make_disc(coarse())->part.mesh.triangles);
}

}  // namespace
}  // namespace fusee::coupon
