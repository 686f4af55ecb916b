#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "fusee/diagnosis/diagnose.h"
#include "inference/pendulum.h"

// The whole diagnosis of a model that is no joint, from measurements to verdict, and its causes on another unit.
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

// Drag that the length has to take: it moves far beyond its tolerance, and explains neither the log nor the rows held out.
TEST(DiagnoseModel, AFitOfAllParametersIsToldBesideTheCause) {
    const Diagnosis found = diagnose_model(Pendulum(0.1, 0.0, 0.002, 3), {}, {.jobs = 1, .progress = {}});
    ASSERT_TRUE(found.absorption.has_value());
    ASSERT_EQ(found.absorption->moved.size(), 1U);
    const Absorption::Moved& length = found.absorption->moved.front();
    EXPECT_EQ(length.name, "length");
    EXPECT_GT(std::abs(length.tolerances), 3.0);
    EXPECT_LT(std::abs(length.with_cause), 0.5 * std::abs(length.value));
    EXPECT_GE(found.absorption->heldout_after, found.absorption->after);
    EXPECT_GT(found.absorption->heldout_after, 2.0 * found.gap.heldout_after);
    EXPECT_FALSE(diagnose_model(Pendulum(0.0, 0.0, 0.003, 4), {}, {.jobs = 1, .progress = {}}).absorption.has_value());
}

TEST(Against, TellsWhichCausesHoldOnAnotherUnit) {
    const DiagnoseOptions options{.jobs = 1, .progress = {}};
    const Diagnosis found = diagnose_model(Pendulum(0.1, 0.0, 0.002, 3), {}, options);
    const auto on = [&](double drag, double length) { return against(Pendulum(drag, 0.0, length, 9), {"other", "none"}, found, options); };
    const Against same = on(0.1, -0.003);
    ASSERT_EQ(same.causes.size(), 1U);
    EXPECT_EQ(same.case_name, "other");
    EXPECT_EQ(same.causes[0].cause.id, "pivot.drag");
    EXPECT_EQ(same.causes[0].survival, Survival::kAgrees);
    EXPECT_NEAR(same.causes[0].there.value, 0.1, 0.01);
    EXPECT_EQ(same.verdict, VerdictKind::kIdentified);
    EXPECT_LT(same.carried, 0.5 * same.before);
    EXPECT_LE(same.refitted, same.carried);
    EXPECT_NEAR(same.refitted, same.own, 0.01);
    EXPECT_EQ(on(0.2, 0.0).causes[0].survival, Survival::kDiffers);
    const Against none = on(0.0, 0.0);
    EXPECT_EQ(none.causes[0].survival, Survival::kGone);
    EXPECT_GT(none.carried, 2.0 * none.before);
    EXPECT_TRUE(none.effects.empty());
}

TEST(DiagnoseModel, APendulumAsDesignedHasNoEffect) {
    const Diagnosis found = diagnose_model(Pendulum(0.0, 0.0, 0.003, 4), {}, {.jobs = 1, .progress = {}});
    EXPECT_TRUE(found.effects.empty());
    EXPECT_LT(found.gap.after, 1.2);
    EXPECT_EQ(found.power.size(), 3U);
}

/// The same pendulum, of which nobody states the length.
class OfUnknownLength final : public inference::Model {
public:
    explicit OfUnknownLength(Pendulum pendulum) : pendulum_(std::move(pendulum)) {}
    [[nodiscard]] const std::vector<inference::Experiment>& experiments() const override { return pendulum_.experiments(); }
    [[nodiscard]] const std::vector<inference::BuildParameter>& build() const override { return build_; }
    [[nodiscard]] const std::vector<inference::Effect>& effects() const override { return pendulum_.effects(); }
    [[nodiscard]] inference::Outputs predict(const inference::Setting& setting, inference::Extent extent) const override {
        return pendulum_.predict(setting, extent);
    }

private:
    Pendulum pendulum_;
    std::vector<inference::BuildParameter> build_{{"length", "m", 0.5, 1.0, false, false}};
};

// 15 cm more than nominal: fitted, told as a length, and no gap. Drag is still seen beside it.
TEST(DiagnoseModel, AFigureThatNobodyStatesIsFitted) {
    const Diagnosis none = diagnose_model(OfUnknownLength(Pendulum(0.0, 0.0, 0.15, 5)), {}, {.jobs = 1, .progress = {}});
    EXPECT_TRUE(none.effects.empty());
    EXPECT_LT(none.gap.before, 1.2);
    EXPECT_NEAR(none.build.at(0).second.value, 1.15, 0.005);
    const Diagnosis drag = diagnose_model(OfUnknownLength(Pendulum(0.1, 0.0, 0.15, 6)), {}, {.jobs = 1, .progress = {}});
    EXPECT_EQ(drag.verdict, VerdictKind::kIdentified);
    ASSERT_EQ(drag.effects.size(), 1U);
    EXPECT_EQ(drag.effects[0].cause.id, "pivot.drag");
    EXPECT_GT(drag.gap.before, 3.0 * drag.gap.after);
    EXPECT_TRUE(drag.build.at(0).second.ci95.holds(1.15)) << drag.build.at(0).second.value;
}

/// The same pendulum, whose length may also be another one than stated.
class OfMisstatedLength final : public inference::Model {
public:
    explicit OfMisstatedLength(Pendulum pendulum)
        : pendulum_(std::move(pendulum)), build_(pendulum_.build()), effects_(pendulum_.effects()) {
        build_.front().cause = {"figure.length", "none"};
        inference::Effect& figure = effects_.emplace_back();
        figure.id = "figure.length";
        figure.parameters = {{"longer", "m", 0.05, {-0.5, 0.5}, 0.0}};
        figure.starts = {1.0, -1.0};
        figure.seen_by = {0, 1, 2};
        figure.meaning = "The length is not what was stated.";
        figure.figure = true;
    }
    [[nodiscard]] const std::vector<inference::Experiment>& experiments() const override { return pendulum_.experiments(); }
    [[nodiscard]] const std::vector<inference::BuildParameter>& build() const override { return build_; }
    [[nodiscard]] const std::vector<inference::Effect>& effects() const override { return effects_; }
    [[nodiscard]] inference::Outputs predict(const inference::Setting& setting, inference::Extent extent) const override {
        inference::Setting own{setting.build, {}};
        for (const inference::Setting::Applied& applied : setting.effects)
            if (applied.cause.id == "figure.length")
                own.build.front() += applied.values.front();
            else
                own.effects.push_back(applied);
        return pendulum_.predict(own, extent);
    }

private:
    Pendulum pendulum_;
    std::vector<inference::BuildParameter> build_;
    std::vector<inference::Effect> effects_;
};

TEST(DiagnoseModel, AFigureFarBeyondItsToleranceIsACauseWithItsSize) {
    const Diagnosis found = diagnose_model(OfMisstatedLength(Pendulum(0.0, 0.0, 0.02, 8)), {}, {.jobs = 1, .progress = {}});
    ASSERT_EQ(found.verdict, VerdictKind::kIdentified) << diagnosis_json(found);
    ASSERT_EQ(found.effects.size(), 1U);
    EXPECT_EQ(found.effects[0].cause.id, "figure.length");
    EXPECT_TRUE(found.effects[0].parameter.ci95.holds(0.02)) << found.effects[0].parameter.value;
    ASSERT_EQ(found.meanings.size(), 1U);
    EXPECT_NE(found.meanings[0].meaning.find("m above what was stated (95 %: "), std::string::npos) << found.meanings[0].meaning;
    EXPECT_EQ(diagnose_model(OfMisstatedLength(Pendulum(0.0, 0.0, 0.003, 4)), {}, {.jobs = 1, .progress = {}}).effects.size(), 0U);
}

TEST(DiagnoseModel, AFigureStandsBesideAnEffect) {
    const Diagnosis found = diagnose_model(OfMisstatedLength(Pendulum(0.1, 0.0, -0.04, 9)), {}, {.jobs = 1, .progress = {}});
    ASSERT_EQ(found.effects.size(), 2U) << diagnosis_json(found);
    for (const FoundEffect& own : found.effects) {
        const bool drag = own.cause.id == "pivot.drag";
        EXPECT_TRUE(own.parameter.ci95.holds(drag ? 0.1 : -0.04)) << own.cause.id << ": " << own.parameter.value;
    }
    EXPECT_LT(found.gap.after, 1.2);
}

TEST(DiagnoseModel, GivesTheSameAnswerWithAnyNumberOfThreads) {
    const Pendulum pendulum(0.06, 0.03, 0.0, 7);
    EXPECT_EQ(diagnosis_json(diagnose_model(pendulum, {}, {.jobs = 1, .progress = {}})),
              diagnosis_json(diagnose_model(pendulum, {}, {.jobs = 4, .progress = {}})));
}

}  // namespace
}  // namespace fusee::diagnosis
