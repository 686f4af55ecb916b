#include "rivals.h"

#include <gtest/gtest.h>

#include "inference/fixture.h"

namespace fusee::diagnosis {
namespace {

using namespace fixtures;

/// Places of what stays open beside the best hypothesis of a rig whose springs in series have these rates.
std::vector<inference::Causes> left_open(double agonist, double antagonist) {
    const gap_case::Case gap_case = measured_case(pulls(2), {kRate, kOtherRate}, {agonist, antagonist}, 1.0, 5);
    const JointProblem problem(gap_case);
    const inference::Search found = search(problem, {});
    EXPECT_EQ(found.best().causes.front().side, "both");
    std::vector<inference::Causes> causes;
    for (const std::size_t h : indistinct(problem, found, 1)) causes.push_back(found.fits[h].causes);
    return causes;
}

// The tolerances of rates, radii and preloads pay for the difference: one size for both sides is likelier, and not sure.
TEST(Indistinct, OneSizeForBothSidesWhereTheSizesOfTheSidesDiffer) {
    const std::vector<inference::Causes> rivals = left_open(0.105, 0.049);
    EXPECT_TRUE(std::any_of(rivals.begin(), rivals.end(), [](const auto& own) { return own.size() == 2 && own[0].id == own[1].id; }));
    for (const inference::Causes& own : left_open(0.105, 0.1)) EXPECT_EQ(own.size(), 1U);
}

}  // namespace
}  // namespace fusee::diagnosis
