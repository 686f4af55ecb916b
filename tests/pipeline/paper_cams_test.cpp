#include <numbers>
#include <string>

#include "fusee/batch/batch.h"
#include "fusee/core/folder.h"
#include "fusee/exchange/part_file.h"
#include "fusee/profile/profile.h"
#include "pipeline/fixture.h"

namespace fusee::pipeline {
namespace {

const std::string kCount = "\"not_judged\":";

/// Springs with the paper's asymptote, of which both cams are made: profiles/paper/new_cams.toml, made once.
class PaperCams : public testing::Test {
protected:
    static const batch::MakeResult& made() {
        static const core::TemporaryFolder folder;
        static const batch::MakeResult result =
            batch::make(profile::read_profile(fixtures::shipped("paper/new_cams")), {.out = folder.path()});
        return result;
    }
};

// Known: theta_inf - theta(tau) = C/(2 k tau^2) for u = 0, 9.0 rad from the law's start; its end leaves 0.38 rad of them.
TEST_F(PaperCams, LawHasThePapersAsymptote) {
    const profile::Profile profile = profile::read_profile(fixtures::shipped("paper/new_cams"));
    const double to_asymptote = 0.0173 / (2.0 * 0.158 * 0.078 * 0.078);
    EXPECT_NEAR(to_asymptote, 9.0, 0.01);
    EXPECT_EQ(profile.rig.gear_friction, 0.28);
    const exchange::PartFile part = exchange::read_part_file(made().folder / "k_pe.json");
    const double law = to_asymptote * (1.0 - 0.078 * 0.078 / (0.38 * 0.38));
    EXPECT_GT(part.target.back().angle_rad, law);
    EXPECT_NEAR(part.target.back().angle_rad, law, 0.05) << "the lead-in adds 2 degrees";
}

// The files carry the law within 0.1 %, K_PE on a helix of more than one turn; report.json counts no rule that was not judged.
TEST_F(PaperCams, AreMadeWithKPeOfMoreThanOneTurn) {
    const batch::MakeResult& result = made();
    ASSERT_TRUE(result.made);
    EXPECT_FALSE(core::any_error(result.findings));
    EXPECT_GT(result.file_errors.arm, 0.0);
    EXPECT_LE(result.file_errors.arm, 1e-3);
    const exchange::PartFile part = exchange::read_part_file(result.folder / "k_pe.json");
    const double turns = (part.target.back().angle_rad - part.target.front().angle_rad) / (2.0 * std::numbers::pi);
    EXPECT_NEAR(turns, 1.377, 0.002);
    const std::string report = core::read_file(result.folder / "report.json");
    std::size_t counts = 0;
    for (std::size_t at = report.find(kCount); at != std::string::npos; at = report.find(kCount, at + 1), ++counts)
        EXPECT_EQ(report.substr(at + kCount.size(), 2), " 0") << "a rule is not judged";
    EXPECT_GT(counts, 0u);
}

}  // namespace
}  // namespace fusee::pipeline
