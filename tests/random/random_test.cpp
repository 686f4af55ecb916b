// A design that nobody has looked at ends made and read back, or refused with what binds: no crash, no silent error. 300 of them here; the
// program random_profiles makes as many as it is asked for (docs/random-profiles.md).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "generator.h"
#include "judge.h"

namespace fs = std::filesystem;

namespace fusee::random_profiles {
namespace {

constexpr std::uint64_t kSeed = 1;
constexpr int kShards = 10, kPerShard = 30;

class RandomProfiles : public testing::TestWithParam<int> {};

TEST_P(RandomProfiles, AreMadeOrRefusedWithWhatBinds) {
    const fs::path folder = fs::path(testing::TempDir()) / fmt::format("fusee_random_{}", GetParam());
    fs::remove_all(folder);
    int made = 0;
    for (const batch::Row& row : make_some(kSeed, GetParam() * kPerShard, kPerShard, folder, 1)) {
        EXPECT_EQ(fault(row), "") << row.profile;
        made += row.outcome == batch::Outcome::kMade ? 1 : 0;
    }
    EXPECT_GT(made, 0);          // else nothing but refusals would have been looked at
    EXPECT_LT(made, kPerShard);  // and the other way round
    if (!HasFailure()) fs::remove_all(folder);
}

INSTANTIATE_TEST_SUITE_P(Shard, RandomProfiles, testing::Range(0, kShards));

TEST(RandomProfile, IsTheSameForTheSameSeedAndNumber) {
    EXPECT_EQ(random_profile(7, 3), random_profile(7, 3));
    EXPECT_NE(random_profile(7, 3), random_profile(7, 4));
    EXPECT_NE(random_profile(7, 3), random_profile(8, 3));
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
    refused.result.findings = {core::required_change("cam.wrap", "too many turns", 2.0, core::Bound::kAtMost, 1.0, "turns")};
    EXPECT_NE(fault(refused), "");
    refused.result.findings[0].where = "k_se";
    refused.result.findings[0].suggestion = "k_se.path.kind = \"helix\"";
    EXPECT_EQ(fault(refused), "");
    batch::Row failed;
    failed.outcome = batch::Outcome::kFailed;
    EXPECT_NE(fault(failed), "");
}

}  // namespace
}  // namespace fusee::random_profiles
