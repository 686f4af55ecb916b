#include <ostream>

#include "fusee/core/units.h"
#include "fusee/exchange/part_file.h"
#include "fusee/pipeline/make.h"
#include "fusee/readback/readback.h"
#include "pipeline/fixture.h"

namespace fusee::pipeline {
namespace {

/// Soft springs: F_SE = 0.05 + 0.02 x, F_PE = 0.05 + 0.01 x + 0.0002 x^2 [Nm], so tau = 0.1 + 0.03 x + 0.0002 x^2 over `turns` of capstan.
/// A linear law on a linear spring has a constant arm sqrt(P/k): 10 mm for K_PE, about 14 mm for K_SE; what is not linear makes them rise.
/// The cable's end is held elsewhere: an axial hole would break into the turns above.
std::string soft_springs(double turns, const std::string& guide) {
    const double x = 2.0 * core::kPi * turns, end = 0.1 + 0.03 * x + 0.0002 * x * x;
    return R"(name = "soft"
[rig]
capstan_radius_mm = 8.0
joint_radius_mm = 8.0
gear_friction = 0.1
least_torque_Nm = 0.12
peak_torque_Nm = 0.2
overdrive_torque_Nm = 0.25
[law]
kind = "polynomial"
series_Nm = [0.05, 0.02]
parallel_Nm = [0.05, 0.01, 0.0002]
start_torque_Nm = 0.1
end_torque_Nm = )" +
           std::to_string(end) + R"(
[cable]
diameter_mm = 0.8
[process]
kind = "fdm"
[tolerances]
chordal_error_mm = 0.005
[k_se.spring]
rate_Nm_per_rad = 0.0613
preload_rad = 1.43
[k_se.features]
anchor_hole_mm = 0.0
[k_se.path]
kind = "helix"
pitch_mm = 4.0
[k_pe.spring]
rate_N_per_m = 100.0
preload_mm = 50.0
[k_pe.features]
anchor_hole_mm = 0.0
[k_pe.path]
kind = "helix"
)" + guide;
}

struct Case {
    const char* name;
    double turns;
    const char* guide;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class LongHelix : public fixtures::TempFolder, public testing::WithParamInterface<Case> {};
INSTANTIATE_TEST_SUITE_P(Pipeline, LongHelix,
                         testing::Values(Case{"paper", 1.4324, "pitch_mm = 4.0\n"},  // the paper's 9 rad
                                         Case{"one_and_a_half", 1.5,
                                              "pitch_mm = 4.0\n[k_pe.guide]\nkind = \"point\"\ndistance_mm = 400.0\nz_mm = 3.0\n"},
                                         Case{"two_and_a_half", 2.5, "pitch_mm = 4.0\n"}),
                         [](const auto& one) { return std::string(one.param.name); });

TEST_P(LongHelix, IsMadeAndCarriesItsLaw) {
    const profile::Profile profile = profile::read_profile(write("soft.toml", soft_springs(GetParam().turns, GetParam().guide)));
    const MakeResult result = make(profile, {.out = folder_ / "out"});
    for (const core::Finding& f : result.findings) EXPECT_NE(f.severity, core::Severity::kRequired) << core::to_line(f);
    ASSERT_TRUE(result.made);
    const exchange::PartFile part = exchange::read_part_file(result.folder / "k_pe.json");
    // The cam turns with the capstan; end_torque is given with six digits.
    EXPECT_NEAR(part.target.back().angle_rad, 2.0 * core::kPi * GetParam().turns, 1e-4);
    const double climb = part.target.back().contact_mm[2] - part.target.front().contact_mm[2];
    EXPECT_NEAR(std::abs(climb), 4.0 * GetParam().turns, 0.4) << "the contact wanders a little against the cam's angle";
    for (const readback::ArmError& e : readback::read_back(result.folder, part)) {
        EXPECT_TRUE(e.passed()) << e.file << " " << e.worst_relative;
        EXPECT_GE(e.rows, 200u);
    }
}

}  // namespace
}  // namespace fusee::pipeline
