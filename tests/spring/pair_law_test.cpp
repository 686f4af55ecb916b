#include <gtest/gtest.h>

#include <cmath>

#include "fusee/core/error.h"
#include "fusee/spring/law.h"
#include "fusee/spring/potential.h"
#include "law_properties.h"

namespace fusee::spring {
namespace {

TEST(PairLaw, CubicPairIsKnownByHand) {
    // F_SE = 0.1 x, F_PE = 0.1 x^3: load 0.2 at x = 1, load 1.0 at x = 2.
    const auto law = make_pair_law(make_polynomial({0.0, 0.1}), make_polynomial({0.0, 0.0, 0.0, 0.1}), 0.2, 1.0);
    ASSERT_TRUE(law);
    EXPECT_NEAR((*law)->angles().high, 1.0, 1e-14);
    const LawPoint end = (*law)->at_load(1.0), start = (*law)->at_load(0.2);
    EXPECT_NEAR(start.theta, 0.0, 1e-14);
    EXPECT_NEAR(end.f_se, 0.2, 1e-14);
    EXPECT_NEAR(end.p, 1.2, 1e-13);
    EXPECT_NEAR(end.u_se, 0.05 * (4.0 - 1.0), 1e-14);
    EXPECT_NEAR(end.u_pe, 0.025 * (16.0 - 1.0), 1e-13);
    EXPECT_NEAR((*law)->at_load(0.1 * 1.5 + 0.1 * 3.375).theta, 0.5, 1e-14);
}

TEST(PairLaw, IsLawfulForEveryKindOfPotential) {
    std::vector<double> x, force;
    for (int i = 0; i < 60; ++i) {
        x.push_back(0.1 * i);
        force.push_back(0.02 + 0.05 * x.back() * (1.0 + 0.1 * x.back()) + 1e-3 * std::sin(40.0 * x.back()));
    }
    const PotentialPtr springs[] = {make_polynomial({0.05, 0.1, 0.0, 0.01}), make_exponential(0.1, 0.6, 0.02), make_tabulated(x, force)};
    for (const PotentialPtr& series : springs)
        for (const PotentialPtr& parallel : springs) {
            const auto law = make_pair_law(series, parallel, 0.12, 0.4);
            ASSERT_TRUE(law);
            expect_lawful(**law, 1e-7);
            EXPECT_TRUE(check_law(**law).empty());
            const auto longer = with_lead_in(*law, 0.05);
            ASSERT_TRUE(longer);
            expect_lawful(**longer, 1e-7);
        }
}

TEST(PairLaw, SteepExponentialsOverflowNowhereInTheirRange) {
    const auto law = make_pair_law(make_exponential(0.01, 25.0, 0.02), make_exponential(0.02, 30.0, 0.02), 0.06, 2.0);
    ASSERT_TRUE(law);
    expect_lawful(**law, 1e-7);
}

TEST(PairLawRefusal, UnreachedLoadsNameWhatIsReached) {
    std::vector<double> x, force;
    for (int i = 0; i < 20; ++i) x.push_back(0.1 * i), force.push_back(0.1 + 0.2 * x.back());
    const PotentialPtr table = make_tabulated(x, force);
    const auto high = make_pair_law(table, table, 0.3, 2.0);
    ASSERT_FALSE(high);
    EXPECT_EQ(high.refusal().front().rule, "law.range");
    EXPECT_NEAR(high.refusal().front().allowed, 2.0 * (0.1 + 0.2 * 1.9), 1e-9);
    const auto low = make_pair_law(table, table, 0.1, 0.9);
    ASSERT_FALSE(low);
    EXPECT_EQ(low.refusal().front().bound, core::Bound::kAtLeast);
    EXPECT_NEAR(low.refusal().front().allowed, 0.2, 1e-9);
    double start = 0.0;
    ASSERT_EQ(std::sscanf(low.refusal().front().suggestion.text().c_str(), "law.start_torque_Nm = %lf", &start), 1);
    EXPECT_TRUE(make_pair_law(table, table, start, 0.9));
}

TEST(PairLawRefusal, FallingLoadIsAStiffnessFindingWhoseChangeWorks) {
    // Load 0.1 + 0.5 x - 0.1 x^3 peaks at x = 1.29 with 0.53 Nm.
    const PotentialPtr series = make_polynomial({0.05, 0.25}), parallel = make_polynomial({0.05, 0.25, 0.0, -0.1});
    const auto refused = make_pair_law(series, parallel, 0.2, 0.6);
    ASSERT_FALSE(refused);
    const core::Finding& finding = refused.refusal().front();
    EXPECT_EQ(finding.rule, "law.stiffness");
    EXPECT_LT(finding.measured, 0.0);
    double end = 0.0;
    ASSERT_EQ(std::sscanf(finding.suggestion.text().c_str(), "law.end_torque_Nm = %lf", &end), 1) << finding.suggestion.text();
    const double soft = std::sqrt(0.25 / 0.3);  // there K_PE's own stiffness is 0, before the load falls
    EXPECT_NEAR(end, 0.98 * (0.1 + 0.5 * soft - 0.1 * std::pow(soft, 3)), 1e-3);
    EXPECT_TRUE(check_law(**make_pair_law(series, parallel, 0.2, end)).empty());
}

TEST(PairLawRefusal, OneSpringOfNegativeStiffnessIsFoundByTheLawsCheck) {
    const auto law = make_pair_law(make_polynomial({0.05, 0.5}), make_polynomial({0.3, -0.1}), 0.4, 0.8);
    ASSERT_TRUE(law);  // load rises: it is a law, but no cam makes it
    const auto findings = check_law(**law);
    ASSERT_FALSE(findings.empty());
    bool stiffness = false;
    for (const core::Finding& finding : findings) stiffness = stiffness || (finding.rule == "law.stiffness" && finding.measured < 0.0);
    EXPECT_TRUE(stiffness);
}

TEST(PairLawRefusal, BadTorquesAreNamed) {
    const PotentialPtr spring = make_polynomial({0.0, 1.0});
    EXPECT_THROW((void)make_pair_law(spring, spring, 0.0, 1.0), core::InvalidInput);
    EXPECT_THROW((void)make_pair_law(spring, spring, 1.0, 0.5), core::InvalidInput);
}

}  // namespace
}  // namespace fusee::spring
