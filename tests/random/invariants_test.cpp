// Laws that hold for every design, on a few near the shipped ones; the program invariant_profiles tries a thousand (docs/robustness.md).
#include "invariants.h"

#include <gtest/gtest.h>

#include "fusee/core/file.h"
#include "generator.h"

namespace fusee::random_profiles {
namespace {

constexpr std::uint64_t kNearSeed = 2;
constexpr int kDesigns = 24;

TEST(Invariants, HoldForDesignsNearTheShippedOnes) {
    std::array<int, kInvariants> tried{};
    for (int number = 0; number < kDesigns; ++number) {
        const Shown shown = try_invariants(near_profile(kNearSeed, number), kNearSeed, number, number < 4);
        for (std::size_t i = 0; i < kInvariants; ++i) {
            if (!shown.error[i]) continue;
            ++tried[i];
            EXPECT_LE(*shown.error[i], kAllowed[i]) << kInvariantNames[i] << " of design " << number;
        }
    }
    for (std::size_t i = 0; i < kInvariants; ++i) EXPECT_GT(tried[i], 0) << kInvariantNames[i];
}

TEST(NearProfile, IsTheSameForTheSameSeedAndNumber) {
    EXPECT_EQ(near_profile(7, 3), near_profile(7, 3));
    EXPECT_NE(near_profile(7, 3), near_profile(7, 4));
    EXPECT_NE(near_profile(7, 3), near_profile(8, 3));
}

}  // namespace
}  // namespace fusee::random_profiles
