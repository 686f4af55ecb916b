#include "power.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "fusee/diagnosis/diagnose.h"
#include "inference/fixture.h"
#include "long_form.h"
#include "next_experiment.h"

// What a verdict without effects excludes (docs/theory/diagnosis.md, eq. 19).
namespace fusee::diagnosis {
namespace {

using namespace fixtures;

Diagnosis answer_to(const gap_case::Case& gap_case) { return diagnose(gap_case, {.jobs = 2, .progress = {}}); }
const Power& of(const Diagnosis& diagnosis, const effects::Cause& cause) {
    return *std::find_if(diagnosis.power.begin(), diagnosis.power.end(), [&](const Power& own) { return own.cause == cause; });
}
gap_case::Rows pulls_and_break_aways() {
    gap_case::Rows rows = pulls(5);
    rows.breakaway = break_aways({0.2, 0.6, 1.0, 1.4}, 3, true).breakaway;
    return rows;
}
gap_case::Rows only_dead_bands() {
    gap_case::Rows rows;
    rows.dead_band = set_points(small_template()).dead_band;
    return rows;
}

TEST(NamedLength, IsWhereEvidenceExceedsTheOddsThreeTimes) {
    // y^2/2 9 L^2/(1 + 9 L^2) - ln(1 + 9 L^2)/2 = 15 + ln 3 for L = 10: y = 6.2485; 1.645 more in 95 of 100 cases, and the margin
    EXPECT_NEAR(named_length(10.0), 1.15 * (6.2485 + 1.645), 1e-3);
    EXPECT_GT(named_length(0.1), named_length(1.0));  // a size that only the prior knows
}

TEST(Power, ASizeThatItStatesIsNamedAndATenthIsNot) {
    const Diagnosis none = answer_to(measured_case(pulls_and_break_aways(), {}, {}, 1.0, 1));
    ASSERT_TRUE(none.effects.empty()) << diagnosis_json(none);
    for (const effects::Cause& cause : {kCoulomb, kOtherRate}) {
        const double least = of(none, cause).least;
        int named = 0, named_small = 0;
        const int cases = case_count(3, 10);
        for (int seed = 1; seed <= cases; ++seed) {
            const Diagnosis found = answer_to(measured_case(pulls_and_break_aways(), {cause}, {least}, 1.0, static_cast<unsigned>(seed)));
            named += std::any_of(found.effects.begin(), found.effects.end(), [&](const FoundEffect& f) { return f.cause.id == cause.id; })
                         ? 1
                         : 0;
            named_small +=
                answer_to(measured_case(pulls_and_break_aways(), {cause}, {0.3 * least}, 1.0, static_cast<unsigned>(seed))).effects.empty()
                    ? 0
                    : 1;
        }
        EXPECT_GE(named, cases - 1) << cause.id;
        EXPECT_LE(named_small, 1) << cause.id;
    }
}

TEST(Power, OfDeadBandsAloneIsTooLittleForAVerdict) {
    const Diagnosis found = answer_to(measured_case(only_dead_bands(), {kCoulomb}, {0.02}, 1.0, 4));
    ASSERT_EQ(found.verdict, VerdictKind::kInconclusive) << diagnosis_json(found);
    EXPECT_TRUE(found.effects.empty());
    EXPECT_FALSE(of(found, kCoulomb).shown);
    EXPECT_TRUE(std::isnan(of(found, {"loop.delay", "none"}).least));  // no dead-band can show it
    ASSERT_FALSE(found.next.empty());
    EXPECT_EQ(found.next_experiment, found.next.front().text);
    for (const NextExperiment& next : found.next) EXPECT_TRUE(next.information > 0.0 && next.information <= 1.0) << next.text;
}

TEST(Power, OfDeadBandsAloneIsEnoughToDoubtTwiceThatSize) {
    const Diagnosis found = answer_to(measured_case(only_dead_bands(), {kCoulomb}, {0.04}, 1.0, 4));
    EXPECT_EQ(found.verdict, VerdictKind::kAmbiguous);
    ASSERT_FALSE(found.alternatives.empty());
    EXPECT_EQ(found.alternatives.front().effects, inference::Causes{kCoulomb});
}

TEST(Power, ListsEveryEffectOfTheLibraryOnEverySide) {
    const Diagnosis found = answer_to(measured_case(pulls_and_break_aways(), {}, {}, 1.0, 2));
    EXPECT_EQ(found.verdict, VerdictKind::kInconclusive);  // nothing of the joint was measured
    std::size_t causes = 0;
    for (const effects::Effect& effect : effects::effect_library()) causes += effect.figure ? 0 : effect.sided ? 3 : 1;
    EXPECT_EQ(found.power.size(), causes);
    for (const Power& own : found.power) EXPECT_GT(own.usual, 0.0) << own.cause.id;
    EXPECT_FALSE(of(found, {"joint.coulomb", "none"}).shown);
    EXPECT_TRUE(of(found, kRate).shown);
}

TEST(Power, AUsualSizeIsKnownToAQuarter) {
    const gap_case::Case gap_case = small_case(pulls(5));
    const JointProblem problem(gap_case);
    const double usual = problem.effect("gear.coulomb").parameters.front().scale;
    Isolability known{{kCoulomb, kOtherCoulomb}, {}, {}, {1.2 * usual, 1.3 * usual}, {}, {}};
    std::vector<Power> powers = powers_of(problem, known);
    const auto shown = [&](const effects::Cause& cause) {
        return std::find_if(powers.begin(), powers.end(), [&](const Power& own) { return own.cause == cause; })->shown;
    };
    EXPECT_TRUE(shown(kCoulomb));
    EXPECT_FALSE(shown(kOtherCoulomb));
    known = {{kStop}, {}, {}, {0.9 * problem.effect("joint.stop").parameters.front().scale}, {}, {}};  // a limit: the greatest
    powers = powers_of(problem, known);
    EXPECT_TRUE(shown(kStop));
    known.named.front() *= 0.8;
    powers = powers_of(problem, known);
    EXPECT_FALSE(shown(kStop));
}

TEST(Power, IsNotStatedBesideACause) {
    EXPECT_TRUE(answer_to(measured_case(pulls_and_break_aways(), {kCoulomb}, {0.08}, 1.0, 3)).power.empty());
}

TEST(ShowingExperiments, ProposeWhatSeesTheCause) {
    const gap_case::Case gap_case = measured_case(only_dead_bands(), {}, {}, 1.0, 4);
    const JointProblem problem(gap_case);
    const inference::Fit null = best_fit(problem, {});
    const std::vector<NextExperiment> delay = showing_experiments(problem, null, {{"loop.delay", "none"}}, 2);
    ASSERT_FALSE(delay.empty());
    EXPECT_EQ(delay.front().experiment, "log");
    const std::vector<NextExperiment> rate = showing_experiments(problem, null, {kRate}, 2);
    ASSERT_FALSE(rate.empty());
    EXPECT_TRUE(std::any_of(rate.begin(), rate.end(), [](const NextExperiment& n) { return n.experiment == "spring_pull"; }));
    EXPECT_TRUE(std::none_of(rate.begin(), rate.end(), [](const NextExperiment& n) { return n.experiment == "breakaway"; }));
}

}  // namespace
}  // namespace fusee::diagnosis
