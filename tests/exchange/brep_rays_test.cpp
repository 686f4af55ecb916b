#include <gtest/gtest.h>

#include <IntCurvesFace_ShapeIntersector.hxx>
#include <TopoDS_Shape.hxx>
#include <cmath>
#include <filesystem>
#include <random>

#include "fusee/core/units.h"
#include "fusee/exchange/brep.h"
#include "fusee/exchange/step.h"
#include "solid/fixture.h"

namespace fs = std::filesystem;

namespace fusee::exchange::brep {
namespace {

/// By OpenCASCADE's own search: the farthest of all hits.
std::optional<double> outermost(IntCurvesFace_ShapeIntersector& search, double azimuth, double z_mm) {
    search.Perform(gp_Lin(gp_Pnt(0.0, 0.0, z_mm), gp_Dir(std::cos(azimuth), std::sin(azimuth), 0.0)), 0.0, 1e4);
    std::optional<double> farthest;
    for (int i = 1; i <= search.NbPnt(); ++i) farthest = std::max(farthest.value_or(0.0), search.WParameter(i));
    return farthest;
}

struct Turned {
    const char* name;
    cam::Cam cam;
};
void PrintTo(const Turned& shape, std::ostream* out) { *out << shape.name; }

// Two ways to the same point, through anchor hole, leg slot and mark too.
class Rays : public testing::TestWithParam<Turned> {};
INSTANTIATE_TEST_SUITE_P(Brep, Rays,
                         testing::Values(Turned{"eccentric", solid::test::disc(0.014, 0.004)},
                                         Turned{"one_and_a_half_turns", solid::test::snail(1.5, 4e-3, 2e-3)}),
                         [](const auto& one) { return std::string(one.param.name); });

TEST_P(Rays, OfAFileAreThoseOfOpenCascade) {
    solid::PartOptions options;
    options.features.leg_slot_width = 1.2e-3;
    options.features.leg_slot_length = 2e-3;
    options.features.leg_slot_radius = 7e-3;
    options.features.leg_slot_depth = 1e-3;
    const solid::Part part = solid::build_part(GetParam().cam, options).value();
    const Brep solid = build(part).value();
    const fs::path path = fs::path(FUSEE_BINARY_DIR) / (std::string("rays_") + GetParam().name + ".step");
    exchange::write_step(path, solid, "part", "fusee test");
    const exchange::StepFile file(path);
    IntCurvesFace_ShapeIntersector search;
    search.Load(*solid.shape, 1e-7);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> azimuth(0.0, core::kTurn), height(core::mm_from_m(part.z_low), core::mm_from_m(part.z_high));
    for (int i = 0; i < 300; ++i) {
        const double a = azimuth(random), z = height(random);
        const auto found = file.outermost(a, z), known = outermost(search, a, z);
        ASSERT_EQ(found.has_value(), known.has_value()) << a << " " << z;
        if (found) {
            EXPECT_NEAR(*found, *known, 1e-7) << a << " " << z;
        }
    }
}

}  // namespace
}  // namespace fusee::exchange::brep
