#include <algorithm>

#include "fusee/batch/batch.h"
#include "fusee/toolpath/read_back.h"
#include "pipeline/fixture.h"

namespace fusee::pipeline {
namespace {

class GCode : public fixtures::TempFolder {
protected:
    [[nodiscard]] batch::MakeResult made(const fixtures::Changes& changes) {
        const auto text = fixtures::with_keys(core::read_file(fixtures::shipped("pnrvsa")),
                                              {{"outputs.formats", "[\"ngc\"]"}, {"outputs.pair", "false"}});
        return batch::make(profile::read_profile(write("pnrvsa.toml", fixtures::with_keys(text, changes))), {.out = folder_ / "out"});
    }
    /// What was read back, as the findings name it.
    [[nodiscard]] static std::vector<std::string> read(const batch::MakeResult& result) {
        std::vector<std::string> readings;
        for (const core::Finding& f : result.findings) {
            if (f.rule != "readback.arm") continue;
            const std::size_t file = f.what.find("k_");
            readings.push_back(f.what.substr(file, f.what.find(')') - file));
            EXPECT_LE(f.measured, 0.03) << f.what;  // 1 um of tolerance on arms from 3 mm; 0.1 % is allowed
        }
        return readings;
    }
};

TEST_F(GCode, OfEveryMethodCarriesTheLaw) {
    if (!toolpath::can_interpret()) GTEST_SKIP() << "rs274 (package linuxcnc-uspace) is not installed";
    for (const fixtures::Changes& changes :
         {fixtures::Changes{}, fixtures::Changes{{"machining.k_se", "\"wrap\""}, {"machining.k_pe", "\"stack\""}}}) {
        const batch::MakeResult result = made(changes);
        ASSERT_TRUE(result.made);
        EXPECT_EQ(read(result), changes.empty()
                                    ? (std::vector<std::string>{"k_se.ngc (read by rs274 lower", "k_se.ngc (read by rs274 upper",
                                                                "k_pe.ngc (read by rs274 wrap"})
                                    : (std::vector<std::string>{"k_se.ngc (read by rs274 wrap", "k_pe.ngc (read by rs274 lower",
                                                                "k_pe.ngc (read by rs274 upper"}));
    }
}

// 20 um on an arm of 3 mm is 0.7 %: the programs are written, and refused for what was read back from them.
TEST_F(GCode, TooCoarseAToleranceIsSeenAndNotMade) {
    if (!toolpath::can_interpret()) GTEST_SKIP() << "rs274 (package linuxcnc-uspace) is not installed";
    const batch::MakeResult result = made({{"machining.tolerance_mm", "0.02"}});
    EXPECT_FALSE(result.made);
    EXPECT_TRUE(std::any_of(result.findings.begin(), result.findings.end(), [](const core::Finding& f) {
        return f.rule == "readback.arm" && f.severity == core::Severity::kError && f.what.find("k_pe.ngc") != std::string::npos;
    }));
}

// The groove of K_PE is cut 2.46 mm above the rotary axis at its lowest, beside a chuck of 21 mm radius.
TEST_F(GCode, WithTheHolderInTheChuckIsRefusedWithLineAndLength) {
    const batch::MakeResult result = made({{"machining.stick_out_mm", "14"}});
    EXPECT_FALSE(result.made);
    const auto found =
        std::find_if(result.findings.begin(), result.findings.end(), [](const core::Finding& f) { return f.rule == "millsim.clamp"; });
    ASSERT_NE(found, result.findings.end());
    EXPECT_EQ(found->where, "k_pe.ngc");
    EXPECT_NE(found->what.find("first in line"), std::string::npos);
    EXPECT_NEAR(found->measured, 21.0 - (14.0 + 2.457), 0.05);
}

TEST_F(GCode, ThatRubsIsAWarningWithTheFeedThatCuts) {
    const batch::MakeResult result = made({{"machining.wrap_feed_mm_per_min", "100"}});
    const auto found = std::find_if(result.findings.begin(), result.findings.end(),
                                    [](const core::Finding& f) { return f.rule == "toolpath.chip_load" && core::is_broken(f); });
    ASSERT_NE(found, result.findings.end());
    EXPECT_NEAR(found->measured, 2.5, 1e-9);
    EXPECT_EQ(found->suggestion.text(), "machining.wrap_feed_mm_per_min = 400");
}

TEST_F(GCode, OfATooWideCutterIsRefused) {
    const batch::MakeResult result = made({{"machining.tool_diameter_mm", "6.2"}});
    EXPECT_FALSE(result.made);
    EXPECT_TRUE(
        std::any_of(result.findings.begin(), result.findings.end(), [](const core::Finding& f) { return f.rule == "toolpath.bore"; }));
}

}  // namespace
}  // namespace fusee::pipeline
