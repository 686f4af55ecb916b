#include <gtest/gtest.h>

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <TopoDS_Shape.hxx>
#include <filesystem>

#include "fusee/exchange/brep.h"
#include "fusee/exchange/step.h"
#include "fusee/pipeline/design.h"

namespace fs = std::filesystem;

namespace fusee::exchange::brep {
namespace {

/// What a client of OpenCASCADE gets that asks for a volume and no more.
double default_volume_mm3(const TopoDS_Shape& shape) {
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties);
    return properties.Mass();
}

/// As a client gets it from the file: reading makes other curves on the faces, and with them other places to integrate at.
double volume_read_mm3(const Brep& solid) {
    const fs::path folder = fs::path(FUSEE_BINARY_DIR) / testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::create_directories(folder);
    const fs::path path = folder / "part.step";
    exchange::write_step(path, solid, "part", "fusee test");
    return exchange::StepFile(path).volume_mm3();
}

// Contours at their worst: radii that fall from 500 mm to 2.8 mm within a millimetre (pnrvsa, pnrvsa_co_design), a corner of 2 mm in 0.05
// rad (first_prototype, K_SE), a helix with flange, lips and run-outs (first_prototype, K_PE).
class Shipped : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Brep, Shipped, testing::Values("pnrvsa", "first_prototype", "pnrvsa_co_design"),
                         [](const auto& one) { return std::string(one.param); });

TEST_P(Shipped, VolumesAreReadRightByDefault) {
    const profile::Profile profile = profile::read_profile(fs::path(FUSEE_SOURCE_DIR) / "profiles" / (std::string(GetParam()) + ".toml"));
    const auto design = pipeline::resolve(profile);
    for (const cam::PartKind kind : {cam::PartKind::kSeries, cam::PartKind::kParallel}) {
        SCOPED_TRACE(to_string(kind));
        const auto designed = pipeline::design_part(kind, *design);
        ASSERT_TRUE(designed);
        const auto solid = build(designed->part);
        ASSERT_TRUE(solid) << core::to_line(solid.refusal().front());
        constexpr double kPromised = 5e-4;
        const double mesh = solid::volume_mm3(designed->part.mesh);
        EXPECT_NEAR(default_volume_mm3(*solid->shape) / mesh, 1.0, kPromised);
        EXPECT_NEAR(volume_read_mm3(*solid) / mesh, 1.0, kPromised);
        EXPECT_LE(solid->faces, 50U);
        EXPECT_LE(solid->deviation_mm, 1e-3);
    }
}

}  // namespace
}  // namespace fusee::exchange::brep
