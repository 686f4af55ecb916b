#include <gtest/gtest.h>

#include "fusee/joint_model/motion.h"
#include "fusee/joint_model/signals.h"
#include "gap_case/fixture.h"
#include "joint_model/fixture.h"

// Dead-band, stiffness loop and co-contraction of the small rig, F_SE = 0.3 x, F_PE = 0.2 theta.
namespace fusee::joint_model {
namespace {

using namespace fixtures;

const gap_case::CaseTemplate kTemplate = small_template();
const gap_case::NominalRig& kRig = kTemplate.rig;

std::vector<double> read(const BuiltRig& rig, const gap_case::Rows& rows, gap_case::Experiment experiment,
                         const gap_case::Protocol& protocol = kTemplate.protocol) {
    return predict_experiment(rig, rows, protocol, experiment);
}
/// Ten times as slow as usual: next to no inertia and drag.
constexpr gap_case::Protocol kSlow{.joint_stiffness_phase = 20.0, .cocontraction_phase = 50.0};
gap_case::Rows some_of(gap_case::Experiment experiment) {
    const gap_case::Rows all = set_points(kTemplate);
    gap_case::Rows rows;
    if (experiment == gap_case::Experiment::kDeadBand)
        for (const gap_case::DeadBandRow& row : all.dead_band)
            if (row.repeat == 1) rows.dead_band.push_back(row);
    if (experiment == gap_case::Experiment::kJointStiffness) rows.joint_stiffness = all.joint_stiffness;
    if (experiment == gap_case::Experiment::kCocontraction) rows.cocontraction = all.cocontraction;
    return rows;
}
constexpr std::array kJoint{gap_case::Experiment::kDeadBand, gap_case::Experiment::kJointStiffness, gap_case::Experiment::kCocontraction};

TEST(PredictDeadBand, ARigWithEqualSidesReadsAWidthThatFrictionMakes) {
    const gap_case::Rows rows = some_of(gap_case::Experiment::kDeadBand);
    const std::vector<double> q = read(faultless(kRig), rows, gap_case::Experiment::kDeadBand);
    ASSERT_EQ(q.size(), 2 * rows.dead_band.size());
    for (std::size_t i = 0; i < rows.dead_band.size(); ++i) {
        EXPECT_LT(q[2 * i], 0.0);
        EXPECT_GT(q[2 * i + 1], 0.0);
        // Exact extremes (docs/theory/dead_band.md): both capstans at opposite limits. No path reads more.
        const double mu = kRig.gear_load_friction, tau = rows.dead_band[i].cocontraction;
        const double difference = (tau / (1.0 - mu) - tau / (1.0 + mu)) / kParallel;  // theta_2 - theta_1 where both K_SE pull equally
        EXPECT_LT(q[2 * i + 1] - q[2 * i], 1.05 * difference / kRig.ratio());         // 5 %: dynamics may carry a capstan past its limit
    }
    const std::vector<double> none = read(built(kRig,
                                                [](BuiltRig& r) {
                                                    for (BuiltSide& side : r.sides) side.gear.load_friction = 0.0;
                                                }),
                                          rows, gap_case::Experiment::kDeadBand);
    for (const double reading : none) EXPECT_NEAR(reading, 0.0, 0.01);  // it comes back; what is left is a slow swing
}

TEST(PredictDeadBand, WidthsAloneAreTheDifferencesAndKnowNoOffset) {
    gap_case::Rows rows = some_of(gap_case::Experiment::kDeadBand);
    const BuiltRig rig = built(kRig, [](BuiltRig& r) { r.joint_offset = 0.05; });
    const std::vector<double> both = read(rig, rows, gap_case::Experiment::kDeadBand);
    rows.dead_band_width_only = true;
    const std::vector<double> width = read(rig, rows, gap_case::Experiment::kDeadBand);
    ASSERT_EQ(width.size(), rows.dead_band.size());
    for (std::size_t i = 0; i < width.size(); ++i) EXPECT_NEAR(width[i], both[2 * i + 1] - both[2 * i], 1e-12);
    EXPECT_EQ(measured_columns(gap_case::Experiment::kDeadBand, rows), std::vector<std::string>{"width_rad"});
    EXPECT_EQ(read(faultless(kRig), rows, gap_case::Experiment::kDeadBand), width);
}

TEST(PredictDeadBand, APushThatIsNotGivenIsAStrongOne) {
    gap_case::Rows given = some_of(gap_case::Experiment::kDeadBand), unknown = given;
    for (gap_case::DeadBandRow& row : unknown.dead_band) row.push_torque = gap_case::DeadBandRow::kNotGiven;
    for (gap_case::DeadBandRow& row : given.dead_band) row.push_torque = 1.5 * kRig.ratio() * row.cocontraction;
    EXPECT_EQ(read(faultless(kRig), given, gap_case::Experiment::kDeadBand),
              read(faultless(kRig), unknown, gap_case::Experiment::kDeadBand));
}

TEST(PredictJoint, AnOffsetMovesQByItselfAndNothingElse) {
    const double offset = 0.04;
    const BuiltRig right = faultless(kRig), off = built(kRig, [&](BuiltRig&r) { r.joint_offset = offset; });
    for (const gap_case::Experiment experiment : kJoint) {
        const gap_case::Rows rows = some_of(experiment);
        const std::vector<double> a = read(right, rows, experiment), b = read(off, rows, experiment);
        const std::vector<std::string> columns = measured_columns(experiment, rows);
        for (std::size_t i = 0; i < a.size(); ++i)
            EXPECT_NEAR(b[i] - a[i], columns[i % columns.size()][0] == 'q' ? offset : 0.0, 1e-12) << columns[i % columns.size()];
    }
}

TEST(PredictJointStiffness, AJointWhoseCapstansAreHeldIsAStraightSpring) {
    const BuiltRig rig = built(kRig, [](BuiltRig& r) {
        for (BuiltSide& side : r.sides) side.gear.coulomb = 3.0;  // they do not even wind in: both cables hang at 0
        r.joint_viscous = 0.05;
    });
    gap_case::Rows rows;
    for (const auto phase : {gap_case::StiffnessPhase::kLoadUp, gap_case::StiffnessPhase::kUnloadUp})
        for (int i = 0; i <= 20; ++i)
            rows.joint_stiffness.push_back({0.5, phase, 0.02 * (phase == gap_case::StiffnessPhase::kLoadUp ? i : 20 - i), 0.0});
    const std::vector<double> q = read(rig, rows, gap_case::Experiment::kJointStiffness, kSlow);
    const double stiffness = kRig.ratio() * kRig.ratio() * kSeries;
    // Behind by drag over stiffness at the loop's speed: 0.052/1.2 s x 0.017 rad/s
    for (std::size_t i = 0; i < q.size(); ++i) EXPECT_NEAR(q[i], rows.joint_stiffness[i].joint_torque / stiffness, 1e-3) << i;
}

TEST(PredictJointStiffness, EveryLevelBeginsAnewAtRest) {
    const gap_case::Rows all = some_of(gap_case::Experiment::kJointStiffness);
    const std::vector<double> q = read(faultless(kRig), all, gap_case::Experiment::kJointStiffness);
    gap_case::Rows last;
    for (const gap_case::StiffnessRow& row : all.joint_stiffness)
        if (row.cocontraction == all.joint_stiffness.back().cocontraction) last.joint_stiffness.push_back(row);
    const std::vector<double> alone = read(faultless(kRig), last, gap_case::Experiment::kJointStiffness);
    EXPECT_EQ(std::vector<double>(q.end() - static_cast<std::ptrdiff_t>(alone.size()), q.end()), alone);
}

TEST(PredictJoint, EveryFileBeginsAnewAtRest) {
    for (const gap_case::Experiment experiment : {gap_case::Experiment::kJointStiffness, gap_case::Experiment::kCocontraction}) {
        const gap_case::Rows one = some_of(experiment);
        gap_case::Rows two = one;
        two.joint_stiffness.insert(two.joint_stiffness.end(), one.joint_stiffness.begin(), one.joint_stiffness.end());
        two.cocontraction.insert(two.cocontraction.end(), one.cocontraction.begin(), one.cocontraction.end());
        two.parts[experiment] = {one.size(experiment), one.size(experiment)};
        const std::vector<double> alone = read(faultless(kRig), one, experiment), both = read(faultless(kRig), two, experiment);
        ASSERT_EQ(both.size(), 2 * alone.size());
        EXPECT_TRUE(std::equal(alone.begin(), alone.end(), both.begin()));
        EXPECT_TRUE(std::equal(alone.begin(), alone.end(), both.begin() + static_cast<std::ptrdiff_t>(alone.size())));
    }
}

TEST(PredictCocontraction, CapstansWindInAtTheirLowerAndPayOutAtTheirUpperLimit) {
    const gap_case::Rows rows = some_of(gap_case::Experiment::kCocontraction);
    const std::vector<double> angles = read(faultless(kRig), rows, gap_case::Experiment::kCocontraction, kSlow);
    const double mu = kRig.gear_load_friction, k = kSeries + kParallel;
    double most = 0.0;
    for (std::size_t i = 0; i < rows.cocontraction.size(); ++i) {
        const double tau = rows.cocontraction[i].motor_torque;
        most = std::max(most, tau / (1.0 + mu) / k);
        const double theta = rows.cocontraction[i].up ? most : std::min(most, tau / (1.0 - mu) / k);
        // Up to 0.08 rad/s: behind by drag, 4e-3 Nms/rad over 0.5 Nm/rad, and swinging by speed sqrt(J/k) = 5 mrad
        EXPECT_NEAR(angles[3 * i], theta, 8e-3) << i;
        EXPECT_EQ(angles[3 * i], angles[3 * i + 1]);
        EXPECT_EQ(angles[3 * i + 2], 0.0);
    }
}

TEST(PredictCocontraction, BacklashLagsByHalfOfItselfEitherWayOnItsSide) {
    const double play = 0.06;
    const gap_case::Rows rows = some_of(gap_case::Experiment::kCocontraction);
    const BuiltRig rig = built(kRig, [&](BuiltRig& r) { r.sides[0].gear.backlash = play; });
    const std::vector<double> with = read(rig, rows, gap_case::Experiment::kCocontraction);
    const std::vector<double> without = read(faultless(kRig), rows, gap_case::Experiment::kCocontraction);
    const std::size_t up = 3 * 40, down = with.size() - 3 * 5;  // far from where it turns
    EXPECT_NEAR(with[up] - without[up], -0.5 * play, 1e-12);
    EXPECT_NEAR(with[down] - without[down], 0.5 * play, 1e-12);
    for (std::size_t i = 0; i < with.size(); ++i) {
        EXPECT_LE(std::abs(with[i] - without[i]), 0.5 * play + 1e-12);
        EXPECT_TRUE(i % 3 == 0 || with[i] == without[i]) << i;
    }
}

/// Readings of push and release at four co-contractions.
std::vector<double> released(double step) {
    const BuiltRig rig = faultless(kRig);
    std::vector<double> q;
    for (const double tau : {0.3, 0.6, 0.9, 1.2}) {
        Motion motion(rig, step);
        motion.lead_to({tau, tau, 0.0}, 0.6);
        motion.hold(0.4);
        motion.hand_damping = 0.05;
        for (const double push : {1.0, -1.0}) {
            motion.lead_to({tau, tau, push}, 1.2);
            motion.hold(0.4);
            motion.lead_to({tau, tau, 0.0}, 3.0);
            q.push_back(motion.q());
        }
    }
    return q;
}

TEST(PredictJoint, TheStepsAreAccurateTo2MradAnd2PercentOfADeadBand) {
    const std::vector<double> exact = released(kSlowStep / 16.0), dead_band = released(kDeadBandStep);
    EXPECT_LT(farthest(released(kSlowStep), exact), 2e-3);
    for (std::size_t i = 0; i < exact.size(); i += 2)
        EXPECT_NEAR((dead_band[i] - dead_band[i + 1]) / (exact[i] - exact[i + 1]), 1.0, 0.02) << i;
}

}  // namespace
}  // namespace fusee::joint_model
