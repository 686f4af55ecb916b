#include "rivals.h"

#include <gtest/gtest.h>

#include "inference/fixture.h"

namespace fusee::diagnosis {
namespace {

using namespace fixtures;

/// A rig whose springs in series have these rates.
struct Rig {
    gap_case::Case gap_case;
    JointProblem problem{gap_case};
    inference::Search found = search(problem, {});
    Rig(double agonist, double antagonist) : gap_case(measured_case(pulls(2), {kRate, kOtherRate}, {agonist, antagonist}, 1.0, 5)) {}

    [[nodiscard]] bool leaves_sides_open() const {
        const std::vector<std::size_t> places = indistinct(problem, found, 1);
        return std::any_of(places.begin(), places.end(), [&](std::size_t h) { return found.fits[h].causes.size() == 2; });
    }
};

// The tolerances of rates, radii and preloads pay for the difference: one size for both sides is likelier, and not sure.
TEST(Indistinct, OneSizeForBothSidesWhereTheSizesOfTheSidesDiffer) {
    Rig unequal(0.105, 0.049);
    EXPECT_EQ(unequal.found.best().causes.front().side, "both");
    EXPECT_TRUE(unequal.leaves_sides_open());
    for (std::size_t h = 0; h < unequal.found.fits.size(); ++h) {
        const Eigen::VectorXd& x = unequal.found.fits[h].x;
        inference::Split& refits = unequal.found.left_out[h] = {};
        for (const double off : {-0.5, 0.5, -0.5, 0.5}) {
            refits.x.push_back(x.array() + off);
            refits.sigma.emplace_back(Eigen::VectorXd::Constant(x.size(), 0.01));
        }
    }
    EXPECT_FALSE(unequal.leaves_sides_open()) << "the experiments disagree about the sizes";
    EXPECT_FALSE(Rig(0.105, 0.1).leaves_sides_open());
}

}  // namespace
}  // namespace fusee::diagnosis
