#include <gtest/gtest.h>

#include "fusee/diagnosis/diagnose.h"
#include "inference/pendulum.h"

// The whole diagnosis of a model that is no joint, from measurements to verdict.
namespace fusee::diagnosis {
namespace {

using fixtures::Pendulum;

TEST(DiagnoseModel, APendulumIsJudgedAsAJointIs) {
    const Diagnosis found = diagnose_model(Pendulum(0.1, 0.0, 0.002, 3), {"pendulum", "none"}, {.jobs = 1, .progress = {}});
    EXPECT_EQ(found.case_name, "pendulum");
    ASSERT_EQ(found.verdict, VerdictKind::kIdentified) << diagnosis_json(found);
    ASSERT_EQ(found.effects.size(), 1U);
    EXPECT_EQ(found.effects[0].cause.id, "pivot.drag");
    EXPECT_TRUE(found.effects[0].parameter.ci95.holds(0.1));
    EXPECT_EQ(found.effects[0].parameter.unit, "Nms");
    EXPECT_LT(found.gap.heldout_after, 0.2 * found.gap.heldout_before);
    EXPECT_LT(found.gap.heldout_after, 1.2);
    ASSERT_EQ(found.experiments.size(), 3U);
    EXPECT_EQ(found.experiments[2].experiment, "fall");
    EXPECT_FALSE(found.where.empty());
    ASSERT_EQ(found.build.size(), 1U);
    EXPECT_EQ(found.build[0].first, "length");
    EXPECT_EQ(found.traces.size(), 3U);
    EXPECT_TRUE(found.next.empty());  // the model has no menu
}

TEST(DiagnoseModel, APendulumAsDesignedHasNoEffect) {
    const Diagnosis found = diagnose_model(Pendulum(0.0, 0.0, 0.003, 4), {}, {.jobs = 1, .progress = {}});
    EXPECT_TRUE(found.effects.empty());
    EXPECT_LT(found.gap.after, 1.2);
    EXPECT_EQ(found.power.size(), 3U);
}

TEST(DiagnoseModel, GivesTheSameAnswerWithAnyNumberOfThreads) {
    const Pendulum pendulum(0.06, 0.03, 0.0, 7);
    EXPECT_EQ(diagnosis_json(diagnose_model(pendulum, {}, {.jobs = 1, .progress = {}})),
              diagnosis_json(diagnose_model(pendulum, {}, {.jobs = 4, .progress = {}})));
}

}  // namespace
}  // namespace fusee::diagnosis
