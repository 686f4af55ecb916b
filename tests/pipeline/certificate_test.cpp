#include "fusee/cam/certificate.h"

#include <gtest/gtest.h>

#include "fusee/cam/cam.h"
#include "fusee/pipeline/design.h"
#include "fusee/profile/profile.h"
#include "pipeline/fixture.h"

namespace fusee::pipeline {
namespace {

class ShippedProfile : public ::testing::TestWithParam<const char*> {};

TEST_P(ShippedProfile, HasBothContoursProven) {
    const profile::Profile profile = profile::read_profile(fixtures::shipped(GetParam()));
    const auto design = resolve(profile);
    ASSERT_TRUE(design);
    for (const cam::PartKind kind : {cam::PartKind::kSeries, cam::PartKind::kParallel}) {
        const auto cam = design_cam(kind, *design);
        ASSERT_TRUE(cam);
        const cam::Certificate c = cam::certify(*cam);
        EXPECT_EQ(c.convex, cam::Proof::kProven);
        EXPECT_EQ(c.ordered, cam::Proof::kProven);
        EXPECT_TRUE(c.open.empty()) << c.open;
        EXPECT_LT(c.seam, 1e-10);
        EXPECT_FALSE(cam::doubt(c, kind));
        double sampled = 1.0;
        for (const cam::Contact& contact : cam->working) sampled = std::min(sampled, contact.path.rho);
        EXPECT_LE(c.working.proven, sampled);
        // The contour comes that near to its bound where the certificate says so; its rows may miss the place (a lead-in's end) by 1 %.
        const double there = std::min(cam->path(c.working.psi.low).rho, cam->path(c.working.psi.high).rho);
        EXPECT_NEAR(there, c.working.proven, 1e-3 * there);
        EXPECT_NEAR(sampled, c.working.proven, 0.02 * sampled);
        ASSERT_TRUE(c.idle);
        EXPECT_GE(c.idle->found, (1.0 - 1e-4) * std::min(design->spec(kind).cam.path.min_idle_curvature_radius, sampled));
    }
}

INSTANTIATE_TEST_SUITE_P(All, ShippedProfile,
                         ::testing::Values("pnrvsa", "pnrvsa_co_design", "first_prototype", "measured_table", "from_dead_band",
                                           "free_curve"),
                         [](const auto& shown) { return shown.param; });

}  // namespace
}  // namespace fusee::pipeline
