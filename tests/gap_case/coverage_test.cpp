#include <gtest/gtest.h>

#include "gap_case/test_day.h"

// Law: what is called a 95 % interval holds the truth in 95 % of 2000 test days. Chance alone leaves 95 +- 1 % (two standard deviations).
namespace fusee::gap_case {
namespace {

struct Case {
    const char* name;
    fixtures::TestDay day;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class Coverage : public ::testing::TestWithParam<Case> {};

TEST_P(Coverage, HoldsTheTruth) {
    const fixtures::TestDay& day = GetParam().day;
    constexpr unsigned kDays = 2000;
    int mu = 0, constant = 0, through_zero = 0;
    for (unsigned seed = 0; seed < kDays; ++seed) {
        const FrictionLine all = identify_friction(fixtures::measure(day, 1000 + seed)).lines.front();
        mu += all.mu_95.holds(day.mu);
        constant += all.constant_95.holds(day.constant);
        through_zero += all.through_zero_mu_95.holds(day.mu);
    }
    const auto expect_held = [](int held, const char* what) {
        EXPECT_GE(held, 93 * kDays / 100) << what;
        EXPECT_LE(held, 97 * kDays / 100) << what;
    };
    expect_held(mu, "mu");
    expect_held(constant, "constant");
    if (day.constant == 0.0) expect_held(through_zero, "mu through zero");
}

INSTANTIATE_TEST_SUITE_P(TestDays, Coverage,
                         ::testing::Values(Case{"gear_scatter", {.relative = 0.03}}, Case{"sensor_scatter", {.absolute = 0.05}},
                                           Case{"both", {.constant = 0.03, .relative = 0.05, .absolute = 0.005, .repeats = 5}},
                                           Case{"few", {.relative = 0.03, .sides = {"one"}, .repeats = 2}},
                                           Case{"few_sensor", {.absolute = 0.01, .sides = {"one"}, .repeats = 2}}),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace fusee::gap_case
