#include "fusee/diagnosis/diagnose.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "fusee/core/error.h"
#include "inference/fixture.h"
#include "predicted_gap.h"
#include "refused.h"

// Whole diagnoses of small cases that the model itself made, with the sensors' noise. What other physics show is for the blind benchmark.
namespace fusee::diagnosis {
namespace {

using namespace fixtures;

/// Motors and springs alone, without a motion to integrate: a diagnosis takes a tenth of a second.
gap_case::Rows parts_alone() {
    gap_case::Rows rows = pulls(5);
    rows.breakaway = break_aways({0.2, 0.6, 1.0, 1.4}, 3, true).breakaway;
    return rows;
}
/// The same with a joint that moves: a second or two.
gap_case::Rows few_rows() {
    const std::vector<gap_case::DeadBandRow> all = set_points(small_template()).dead_band;
    gap_case::Rows rows = parts_alone();
    for (std::size_t i = 3; i < all.size(); i += 9) rows.dead_band.push_back(all[i]);
    rows.log = short_log(1.0).log;
    return rows;
}
const effects::Cause kWound{"se.preload", "antagonist"};

Diagnosis diagnosed(const gap_case::Case& gap_case, unsigned jobs = 1) { return diagnose(gap_case, {.jobs = jobs, .progress = {}}); }
const FoundEffect* found(const Diagnosis& diagnosis, const effects::Cause& cause) {
    const auto at =
        std::find_if(diagnosis.effects.begin(), diagnosis.effects.end(), [&](const FoundEffect& f) { return f.cause == cause; });
    return at == diagnosis.effects.end() ? nullptr : &*at;
}

TEST(Diagnose, ARigAsDesignedHasNoEffect) {
    const Diagnosis none = diagnosed(measured_case(few_rows(), {}, {}, 1.0, 3));
    EXPECT_EQ(none.verdict, VerdictKind::kInconclusive) << diagnosis_json(none);  // few rows: small effects would not be seen
    EXPECT_TRUE(none.effects.empty());
    EXPECT_LT(none.gap.before, 2.0);
}

TEST(Diagnose, AnEffectOfOneSideIsNamedWithItsSize) {
    const double size = 0.06;
    const Diagnosis diagnosis = diagnosed(measured_case(few_rows(), {kCoulomb}, {size}, 1.0, 4));
    EXPECT_EQ(diagnosis.verdict, VerdictKind::kIdentified);
    ASSERT_EQ(diagnosis.effects.size(), 1U) << diagnosis_json(diagnosis);
    EXPECT_EQ(diagnosis.effects[0].cause, kCoulomb);
    const Parameter& parameter = diagnosis.effects[0].parameter;
    EXPECT_TRUE(parameter.ci95.holds(size)) << parameter.ci95.low << " to " << parameter.ci95.high;
    EXPECT_LT(parameter.ci95.width(), size);
    EXPECT_EQ(parameter.unit, "Nm");
    EXPECT_LT(diagnosis.gap.heldout_after, 0.5 * diagnosis.gap.heldout_before);
    ASSERT_FALSE(diagnosis.where.empty());
}

TEST(Diagnose, TwoEffectsAreBothNamed) {
    const Diagnosis diagnosis = diagnosed(measured_case(parts_alone(), {kCoulomb, kWound}, {0.06, -0.25}, 1.0, 5));
    EXPECT_EQ(diagnosis.verdict, VerdictKind::kIdentified) << diagnosis_json(diagnosis);
    ASSERT_EQ(diagnosis.effects.size(), 2U);
    const FoundEffect *rubs = found(diagnosis, kCoulomb), *wound = found(diagnosis, kWound);
    ASSERT_TRUE(rubs != nullptr && wound != nullptr);
    EXPECT_TRUE(rubs->parameter.ci95.holds(0.06));
    EXPECT_TRUE(wound->parameter.ci95.holds(-0.25));
}

TEST(Diagnose, ABumpInOneSpringIsUnknownAndFoundWhereItIs) {
    gap_case::Case gap_case = measured_case(parts_alone(), {}, {}, 1.0, 6);
    for (gap_case::SpringPull& row : gap_case.rows.spring_pull)
        if (row.series && row.side == gap_case::Side::kAgonist) row.torque += 0.15 * std::sin(4.0 * row.deflection);
    const Diagnosis diagnosis = diagnosed(gap_case);
    EXPECT_EQ(diagnosis.verdict, VerdictKind::kUnknown) << diagnosis_json(diagnosis);
    EXPECT_TRUE(diagnosis.effects.empty());
    ASSERT_FALSE(diagnosis.where.empty());
    EXPECT_EQ(diagnosis.where[0].experiment, "spring_pull");
    EXPECT_EQ(diagnosis.where[0].component, "se agonist");
    // Effects that are not named are not in the figures either.
    const JointProblem problem(gap_case);
    const inference::Fit null = best_fit(problem, {});
    ASSERT_EQ(diagnosis.build.size(), problem.build().size());
    for (std::size_t k = 0; k < problem.build().size(); ++k)
        EXPECT_DOUBLE_EQ(diagnosis.build[k].second.value, null.x[static_cast<Eigen::Index>(k)] * problem.build()[k].sigma);
}

TEST(Diagnose, WhatStandsIsNamedBesideABumpThatNothingExplains) {
    const double size = 0.06;
    gap_case::Case gap_case = measured_case(parts_alone(), {kCoulomb}, {size}, 1.0, 6);
    for (gap_case::SpringPull& row : gap_case.rows.spring_pull)
        if (row.series && row.side == gap_case::Side::kAgonist) row.torque += 0.15 * std::sin(4.0 * row.deflection);
    const Diagnosis diagnosis = diagnosed(gap_case);
    EXPECT_EQ(diagnosis.verdict, VerdictKind::kPartlyExplained) << diagnosis_json(diagnosis);
    ASSERT_EQ(diagnosis.effects.size(), 1U);
    EXPECT_EQ(diagnosis.effects[0].cause, kCoulomb);
    EXPECT_TRUE(diagnosis.effects[0].parameter.ci95.holds(size));
    ASSERT_FALSE(diagnosis.where.empty());  // what remains
    EXPECT_EQ(diagnosis.where[0].experiment, "spring_pull");
    EXPECT_EQ(diagnosis.where[0].component, "se agonist");
    EXPECT_LT(diagnosis.gap.after, diagnosis.gap.before);
    // One hypothesis: what the file predicts has the gap that the file states.
    const Diagnosis read = parse_diagnosis(diagnosis_json(diagnosis), "diagnosis.json");
    EXPECT_EQ(read.verdict, VerdictKind::kPartlyExplained);
    EXPECT_NEAR(predicted_gap(gap_case, read), diagnosis.gap.after, 1e-6 * diagnosis.gap.after);
}

TEST(Diagnose, AnEffectWithDifferentSizesOnTheSidesIsTwo) {
    const Diagnosis diagnosis = diagnosed(measured_case(parts_alone(), {kCoulomb, kOtherCoulomb}, {0.03, 0.08}, 1.0, 12));
    EXPECT_EQ(diagnosis.verdict, VerdictKind::kIdentified) << diagnosis_json(diagnosis);
    ASSERT_EQ(diagnosis.effects.size(), 2U);
    const FoundEffect *less = found(diagnosis, kCoulomb), *more = found(diagnosis, kOtherCoulomb);
    ASSERT_TRUE(less != nullptr && more != nullptr);
    EXPECT_TRUE(less->parameter.ci95.holds(0.03));
    EXPECT_TRUE(more->parameter.ci95.holds(0.08));
}

TEST(Diagnose, CausesThatNoMeasurementTellsApartAreAmbiguous) {
    // Pulls of straight springs: F = k x/(1 + k c) is a straight spring of another rate. So is one with other arms.
    gap_case::Rows rows = pulls(5);
    const Diagnosis diagnosis = diagnosed(measured_case(rows, {kRate}, {-0.15}, 1.0, 13));
    EXPECT_EQ(diagnosis.verdict, VerdictKind::kAmbiguous) << diagnosis_json(diagnosis);
    ASSERT_FALSE(diagnosis.alternatives.empty());
}

TEST(Diagnose, OneUnknownEffectThatTwoKnownOnesImitateIsUnknown) {
    gap_case::Rows rows = few_rows();
    rows.breakaway = break_aways({0.2, 0.6, 1.0, 1.4}, 6, true).breakaway;
    const effects::Cause drift{"term.gear.drift", "antagonist"};
    const Diagnosis diagnosis = diagnosed(measured_case(rows, {drift}, {-0.4}, 1.0, 9), 2);
    EXPECT_EQ(diagnosis.verdict, VerdictKind::kUnknown) << diagnosis_json(diagnosis);
    EXPECT_TRUE(diagnosis.effects.empty());
    ASSERT_EQ(diagnosis.unknown_terms.size(), 1U);
    EXPECT_EQ(diagnosis.unknown_terms[0].found.cause, drift);
    EXPECT_NEAR(diagnosis.unknown_terms[0].found.parameter.value, -0.4, 0.1);
    ASSERT_FALSE(diagnosis.alternatives.empty());
    EXPECT_EQ(diagnosis.alternatives[0].effects.size(), 2U) << diagnosis_json(diagnosis);
    EXPECT_TRUE(std::any_of(diagnosis.remarks.begin(), diagnosis.remarks.end(),
                            [](const std::string& r) { return r.find("explains the gap better than gear.") != std::string::npos; }));
}

TEST(Diagnose, OneLoadAloneLeavesFrictionLawsAmbiguousAndAsksForAnother) {
    const gap_case::Case gap_case = measured_case(break_aways({0.8}, 8, false), {kCoulomb}, {0.12}, 1.0, 8);
    const Diagnosis diagnosis = diagnosed(gap_case);
    EXPECT_EQ(diagnosis.verdict, VerdictKind::kAmbiguous) << diagnosis_json(diagnosis);
    inference::Causes named;
    for (const FoundEffect& effect : diagnosis.effects) named.push_back(effect.cause);
    for (const Alternative& other : diagnosis.alternatives) named.insert(named.end(), other.effects.begin(), other.effects.end());
    EXPECT_GE(named.size(), 2U);
    // At one load, driven back: whatever raises it by some share is as good, and nothing of the other side.
    const std::set<std::string> similar{"gear.coulomb",   "gear.load_friction", "gear.load_quadratic",
                                        "gear.asymmetry", "gear.stribeck",      "sensor.torque_scale"};
    for (const effects::Cause& cause : named) {
        EXPECT_TRUE(similar.contains(cause.id)) << cause.id;
        EXPECT_EQ(cause.side, "agonist") << cause.id;
    }
    EXPECT_FALSE(diagnosis.next_experiment.empty());
}

TEST(Diagnose, GivesTheSameAnswerWithAnyNumberOfThreads) {
    gap_case::Rows rows = pulls(8);
    rows.breakaway = break_aways({0.3, 0.9}, 2, true).breakaway;
    const gap_case::Case gap_case = measured_case(rows, {kCoulomb}, {0.06}, 1.0, 9);
    EXPECT_EQ(diagnosis_json(diagnosed(gap_case, 1)), diagnosis_json(diagnosed(gap_case, 4)));
}

TEST(Diagnose, FewRowsEndInWords) {
    gap_case::Case four = measured_case(break_aways({0.3, 0.9, 1.4}, 1, true), {}, {}, 1.0, 10);
    four.rows.breakaway.resize(4);
    gap_case::Case three = four;
    EXPECT_NO_THROW((void)diagnosed(four));
    three.rows.breakaway.resize(3);
    EXPECT_EQ(field_refused([&] { return diagnosed(three); }), "experiments");
    three.rows.breakaway.clear();
    EXPECT_EQ(field_refused([&] { return diagnosed(three); }), "experiments");
}

TEST(Diagnose, WhatWasFoundPredictsWhatWasNotMeasured) {
    const gap_case::Case gap_case = measured_case(parts_alone(), {kWound}, {-0.25}, 1.0, 11);
    const gap_case::Case other = measured_case(pulls(1), {kWound}, {-0.25}, 0.0, 1);
    const auto off = [&](const Diagnosis& model) {
        const gap_case::Rows predicted = predict(gap_case, model, other.rows);
        double sum = 0.0;
        for (std::size_t i = 0; i < predicted.spring_pull.size(); ++i)
            sum += std::abs(predicted.spring_pull[i].torque - other.rows.spring_pull[i].torque);
        return sum;
    };
    EXPECT_LT(off(diagnosed(gap_case)), 0.2 * off({}));
}

// 10,000 rows would take hours; a reader is told before the first minute is gone.
TEST(Diagnose, ACaseThatWouldTakeHoursIsRefusedAtOnce) {
    gap_case::Rows rows = few_rows();
    for (int i = 0; i < 10000; ++i) rows.joint_stiffness.push_back({0.5 + 1e-4 * i, gap_case::StiffnessPhase::kLoadUp, 0.1, 0.01});
    gap_case::Case gap_case = measured_case(parts_alone(), {}, {}, 1.0, 3);
    gap_case.rows.joint_stiffness = rows.joint_stiffness;
    try {
        (void)diagnosed(gap_case);
        FAIL() << "diagnosed";
    } catch (const core::InvalidInput& e) {
        EXPECT_EQ(e.field(), "experiments.joint_stiffness");
        EXPECT_NE(std::string(e.what()).find("10000 rows with a motion "), std::string::npos) << e.what();
        EXPECT_NE(e.allowed().find("begins a loop from rest"), std::string::npos) << e.what();
    }
}

TEST(Diagnose, AnyNumberOfThreadsIsTaken) {
    const gap_case::Case gap_case = measured_case(parts_alone(), {kCoulomb}, {0.06}, 1.0, 4);
    EXPECT_EQ(diagnosis_json(diagnosed(gap_case, 100'000)), diagnosis_json(diagnosed(gap_case, 1)));
}

}  // namespace
}  // namespace fusee::diagnosis
