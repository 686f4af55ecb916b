#include <ostream>

#include "fusee/batch/batch.h"
#include "fusee/core/units.h"
#include "fusee/exchange/part_file.h"
#include "fusee/formats/format.h"
#include "pipeline/fixture.h"
#include "pipeline/soft_springs.h"

namespace fusee::pipeline {
namespace {

struct HelixCase {
    const char* name;
    double turns;
    const char* guide;
};
void PrintTo(const HelixCase& c, std::ostream* out) { *out << c.name; }

class LongHelix : public fixtures::TempFolder, public testing::WithParamInterface<HelixCase> {};
INSTANTIATE_TEST_SUITE_P(Pipeline, LongHelix,
                         testing::Values(HelixCase{"paper", 1.4324, "pitch_mm = 4.0\n"},  // the paper's 9 rad
                                         HelixCase{"one_and_a_half", 1.5,
                                                   "pitch_mm = 4.0\n[k_pe.guide]\nkind = \"point\"\ndistance_mm = 400.0\nz_mm = 3.0\n"},
                                         HelixCase{"two_and_a_half", 2.5, "pitch_mm = 4.0\n"}),
                         [](const auto& one) { return std::string(one.param.name); });

TEST_P(LongHelix, IsMadeAndCarriesItsLaw) {
    const profile::Profile profile = profile::read_profile(write("soft.toml", fixtures::soft_springs(GetParam().turns, GetParam().guide)));
    const batch::MakeResult result = batch::make(profile, {.out = folder_ / "out"});
    for (const core::Finding& f : result.findings) EXPECT_NE(f.severity, core::Severity::kError) << core::to_line(f);
    ASSERT_TRUE(result.made);
    const exchange::PartFile part = exchange::read_part_file(result.folder / "k_pe.json");
    // The cam turns with the capstan; end_torque is given with six digits.
    EXPECT_NEAR(part.target.back().angle_rad, 2.0 * core::kPi * GetParam().turns, 1e-4);
    const double climb = part.target.back().contact_mm[2] - part.target.front().contact_mm[2];
    EXPECT_NEAR(std::abs(climb), 4.0 * GetParam().turns, 0.4) << "the contact wanders a little against the cam's angle";
    for (const readback::ArmError& e : formats::read_back(result.folder, part)) {
        EXPECT_TRUE(e.passed()) << e.file << " " << e.worst_relative;
        EXPECT_GE(e.rows, 200u);
    }
}

}  // namespace
}  // namespace fusee::pipeline
