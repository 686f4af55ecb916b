// A design that nobody has looked at ends made and read back, or refused with what binds: no crash, no silent error. 36 of them here; the
// program random_profiles makes as many as it is asked for (docs/robustness.md).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "fusee/pipeline/design.h"
#include "generator.h"
#include "judge.h"
#include "long_form.h"
#include "pipeline/fixture.h"

namespace fs = std::filesystem;

namespace fusee::random_profiles {
namespace {

constexpr std::uint64_t kSeed = 1;
constexpr int kShards = 3, kPerShard = 30;  // in the short form twelve of each, of which some are made

class RandomProfiles : public testing::TestWithParam<int> {};

TEST_P(RandomProfiles, AreMadeOrRefusedWithWhatBinds) {
    const fs::path folder = fs::path(testing::TempDir()) / fmt::format("fusee_random_{}", GetParam());
    fs::remove_all(folder);
    int made = 0;
    const int first = GetParam() * kPerShard + fixtures::case_count(12, 0), tried = fixtures::case_count(12, kPerShard);
    for (const batch::Row& row : make_some(kSeed, first, tried, folder, 1)) {
        EXPECT_EQ(fault(row), "") << row.profile;
        made += row.outcome == batch::Outcome::kMade ? 1 : 0;
    }
    EXPECT_GT(made, 0);      // else only refusals were tested
    EXPECT_LT(made, tried);  // and the other way round
    if (!HasFailure()) fs::remove_all(folder);
}

INSTANTIATE_TEST_SUITE_P(Shard, RandomProfiles, testing::Range(0, kShards));

TEST(RandomProfile, IsTheSameForTheSameSeedAndNumber) {
    EXPECT_EQ(random_profile(7, 3), random_profile(7, 3));
    EXPECT_NE(random_profile(7, 3), random_profile(7, 4));
    EXPECT_NE(random_profile(7, 3), random_profile(8, 3));
}

/// Of one part of a design: what forbids it, or nothing.
core::Findings refused(cam::PartKind kind, const std::string& text) {
    const profile::Profile profile = profile::parse_profile(text, "random.toml");
    const auto part = pipeline::design_part(kind, *pipeline::resolve(profile));
    return part ? core::Findings{} : part.refusal();
}

// Two helices whose neighbouring turns meet, one of constant pitch and one aimed at its guide: what is suggested is what mends them.
TEST(RandomProfile, AHelixThatMeetsItselfIsToldHowSteepItHasToBe) {
    for (const auto& [number, key] :
         fixtures::some_of<std::pair<int, const char*>>({{338, "k_se.guide.z_mm"}, {13, "k_se.path.pitch_mm"}}, 1)) {
        const std::string text = random_profile(1, number);
        const core::Findings refusal = refused(cam::PartKind::kSeries, text);
        ASSERT_EQ(refusal.size(), 1u) << number;
        EXPECT_EQ(refusal[0].rule, "solid.validity");
        EXPECT_TRUE(refusal[0].place) << number;
        const std::string prefix = std::string(key) + " = ";
        ASSERT_TRUE(refusal[0].suggestion.text().starts_with(prefix)) << refusal[0].suggestion.text();
        for (const core::Finding& f :
             refused(cam::PartKind::kSeries, fixtures::with_key(text, key, refusal[0].suggestion.text().substr(prefix.size()))))
            EXPECT_FALSE(f.rule.starts_with("solid.")) << core::to_line(f);
    }
}

// Planar parts whose leg slot or keyway passes an edge of the groove within a micrometre: rounded, they folded over.
TEST(RandomProfile, ACutBesideAnEdgeIsNoFold) {
    for (const auto& [number, kind] :
         {std::pair{898, cam::PartKind::kSeries}, {2046, cam::PartKind::kParallel}, {6284, cam::PartKind::kSeries}})
        for (const core::Finding& f : refused(kind, random_profile(1, number)))
            EXPECT_FALSE(f.rule.starts_with("solid.")) << core::to_line(f);
}

// A planar part whose volume OpenCASCADE's default integral misreads with its idle arc in two or three faces: it gets more of them.
TEST(RandomProfile, AnIdleArcGetsTheFacesThatItsVolumeNeeds) {
    const fs::path folder = fs::path(testing::TempDir()) / "fusee_random_faces";
    fs::remove_all(folder);
    const auto rows = make_some(1, 261, 1, folder, 1);
    EXPECT_EQ(rows.front().outcome, batch::Outcome::kMade);
    EXPECT_EQ(fault(rows.front()), "");
    fs::remove_all(folder);
}

// Law: a made design from which a file is gone, and a refusal that names nothing, are faults.
TEST(RandomProfile, JudgeFindsWhatIsWrong) {
    batch::Row made;
    made.outcome = batch::Outcome::kMade;
    made.result.made = true;
    made.result.folder = fs::path(testing::TempDir()) / "nothing_is_here";
    EXPECT_NE(fault(made), "");
    batch::Row refused;
    refused.outcome = batch::Outcome::kRefused;
    EXPECT_NE(fault(refused), "");
    refused.result.findings = {core::error_finding("cam.wrap", "too many turns", 2.0, core::Bound::kAtMost, 1.0, "turns")};
    EXPECT_NE(fault(refused), "");
    refused.result.findings[0].where = "k_se";
    refused.result.findings[0].suggestion = core::change("k_se.path.kind", core::quoted("helix"));
    EXPECT_EQ(fault(refused), "");
    batch::Row failed;
    failed.outcome = batch::Outcome::kFailed;
    EXPECT_NE(fault(failed), "");
}

}  // namespace
}  // namespace fusee::random_profiles
