#include "fusee/inference/pursue.h"

#include <gtest/gtest.h>

#include "inference/fixture.h"

namespace fusee::inference {
namespace {

using namespace fixtures;

/// Pulls of the springs and break-aways: they need no motion.
gap_case::Rows some_rows() {
    gap_case::Rows rows = pulls(2);
    rows.breakaway = break_aways({0.2, 0.6, 1.0, 1.4}, 3, true).breakaway;
    return rows;
}

/// The terms of a rig with `cause` at `size`, or of a faultless one.
std::optional<FoundTerms> pursued(const Causes& causes, const std::vector<double>& sizes, unsigned seed) {
    const gap_case::Case gap_case = measured_case(some_rows(), causes, sizes, 1.0, seed);
    const JointProblem problem(gap_case);
    const Fit null = best_fit(problem, {});
    return pursue_terms(problem, null, null.log_evidence, possible_terms(problem), {.jobs = 2, .progress = {}});
}

TEST(PursueTerms, AFaultlessRigHasNone) { EXPECT_FALSE(pursued({}, {}, 3)); }

TEST(PursueTerms, AStepOfACamIsFoundOnItsSideWithItsSizeAndPlace) {
    const effects::Cause step{"term.k_pe.step", "antagonist"};
    const std::optional<FoundTerms> found = pursued({step}, {-0.2}, 5);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->fit.causes.front(), step);
    const Eigen::Index size = found->fit.x.size() - 2;
    ASSERT_EQ(found->fit.causes.size(), 1U);
    EXPECT_NEAR(found->fit.x[size] * 0.15, -0.2, 0.02);
    EXPECT_NEAR(found->fit.x[size + 1] * 0.3, 0.5, 0.02);
    EXPECT_GT(found->log_odds.front(), 0.0);
    EXPECT_GT(found->probability.front(), 0.9);
}

TEST(PursueTerms, FrictionThatDriftsOverTheSessionIsFoundInTheOrderOfTheRows) {
    const effects::Cause drift{"term.gear.drift", "agonist"};
    const gap_case::Case gap_case = measured_case(break_aways({0.2, 0.6, 1.0, 1.4}, 8, true), {drift}, {-0.5}, 1.0, 4);
    const JointProblem problem(gap_case);
    const Fit null = best_fit(problem, {});
    const std::optional<FoundTerms> found =
        pursue_terms(problem, null, null.log_evidence, possible_terms(problem), {.jobs = 2, .progress = {}});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->fit.causes, Causes{drift});
    EXPECT_NEAR(found->fit.x[found->fit.x.size() - 2] * 0.4, -0.5, 0.15);
}

// One half alone is not worth its cost: 20 nats of 25; both are worth 130.
TEST(PursueTerms, ATermOfBothSidesIsFoundOnBoth) {
    const Causes both{{"term.motor.ripple", "agonist"}, {"term.motor.ripple", "antagonist"}};
    gap_case::Rows rows = short_log(4.0);
    rows.cocontraction = set_points(small_template()).cocontraction;
    const gap_case::Case gap_case = measured_case(rows, both, {0.06, 0.06}, 1.0, 6);
    const JointProblem problem(gap_case);
    const Fit null = best_fit(problem, {});
    const std::optional<FoundTerms> found =
        pursue_terms(problem, null, null.log_evidence, possible_terms(problem), {.jobs = 2, .progress = {}});
    ASSERT_TRUE(found);
    ASSERT_EQ(found->fit.causes.size(), 2U);
    for (const effects::Cause& cause : both) EXPECT_EQ(std::count(found->fit.causes.begin(), found->fit.causes.end(), cause), 1);
    for (std::size_t c = 0; c < 2; ++c) {
        const Eigen::Index size = problem.effect_size_index(found->fit.causes, c);
        const Effect& effect = problem.effect(both[c].id);
        EXPECT_NEAR(found->fit.x[size] * effect.parameters[0].scale, 0.06, 0.006);
    }
}

/// A joint that is loaded both ways, with one term.
void expect_found_by_loading(const char* id, double size, double within) {
    gap_case::Rows rows;
    rows.joint_stiffness = set_points(small_template()).joint_stiffness;
    const effects::Cause cause{id, "none"};
    const gap_case::Case gap_case = measured_case(rows, {cause}, {size}, 1.0, 7);
    const JointProblem problem(gap_case);
    const Fit null = best_fit(problem, {});
    const std::optional<FoundTerms> found =
        pursue_terms(problem, null, null.log_evidence, possible_terms(problem), {.jobs = 2, .progress = {}});
    ASSERT_TRUE(found) << id;
    EXPECT_EQ(found->fit.causes, Causes{cause});
    EXPECT_NEAR(found->fit.x[problem.effect_size_index(found->fit.causes, 0)] * problem.effect(id).parameters[0].scale, size, within);
}

TEST(PursueTerms, ALinkWithPlayIsFound) { expect_found_by_loading("term.joint_encoder.play", 0.06, 0.01); }

TEST(PursueTerms, ALinkFarSofterThanUsualIsFound) { expect_found_by_loading("term.joint_encoder.flexibility", 0.5, 0.02); }

TEST(TermsLike, NameTheEffectAmongThoseTheyAreConfusedWith) {
    const gap_case::Case parts = small_case(some_rows());
    EXPECT_TRUE(terms_like(JointProblem(parts), "joint.gravity").empty());  // no experiment moves the joint
    gap_case::Case moving = parts;
    moving.rows.dead_band.push_back({});
    const JointProblem problem(moving);
    EXPECT_EQ(terms_like(problem, "joint.gravity"), (Causes{{"term.joint.spring", "none"}}));
    EXPECT_EQ(terms_like(problem, "figure.joint_radius"), (Causes{{"term.joint.arm", "none"}, {"term.joint_encoder.scale", "none"}}));
    EXPECT_TRUE(terms_like(problem, "joint.stop").empty());
}

TEST(PursueTerms, TwoTermsAreFoundOneAfterTheOther) {
    const effects::Cause crack{"term.k_se.step", "agonist"}, relaxation{"term.k_pe.relaxation", "antagonist"};
    const std::optional<FoundTerms> found = pursued({crack, relaxation}, {0.3, 0.4}, 8);
    ASSERT_TRUE(found);
    ASSERT_EQ(found->fit.causes.size(), 2U);
    for (const effects::Cause& cause : {crack, relaxation})
        EXPECT_EQ(std::count(found->fit.causes.begin(), found->fit.causes.end(), cause), 1) << cause.id;
}

}  // namespace
}  // namespace fusee::inference
