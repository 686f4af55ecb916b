#include <gtest/gtest.h>

#include "fusee/joint_model/signals.h"
#include "joint_model/fixture.h"

namespace fusee::joint_model {
namespace {

using namespace fixtures;

/// One spring up and down again, in steps that are longer than the hysteresis takes to turn over.
gap_case::Rows pulled(bool series, gap_case::Side side) {
    gap_case::Rows rows;
    for (const bool load : {true, false})
        for (int i = 0; i <= 30; ++i) {
            const double x = 0.1 + 3.6 * (load ? i : 30 - i) / 30.0;
            rows.spring_pull.push_back({series, side, load, x, 0.0});
        }
    return rows;
}
std::vector<double> torques(const BuiltRig& rig, const gap_case::Rows& rows) {
    return predict_experiment(rig, rows, {}, gap_case::Experiment::kSpringPull);
}

TEST(PredictSpringPull, AFaultlessSpringPullsAsItsCurveSaysBothWays) {
    const BuiltRig rig = faultless(stiffening_rig());
    for (const gap_case::Side side : {gap_case::Side::kAgonist, gap_case::Side::kAntagonist})
        for (const bool series : {true, false}) {
            const gap_case::Rows rows = pulled(series, side);
            const std::vector<double> pull = torques(rig, rows);
            for (std::size_t i = 0; i < pull.size(); ++i) {
                const Stiffening& law = series ? kSe : kPe;
                EXPECT_NEAR(pull[i], law.torque(rows.spring_pull[i].deflection), 1e-4 * law.torque(kEnd));
            }
        }
}

TEST(PredictSpringPull, HysteresisAddsItsShareOnTheWayUpAndTakesItOnTheWayDown) {
    const double a = 0.12;
    const BuiltRig rig = built(stiffening_rig(), [&](BuiltRig& r) { r.sides[1].pe_build.hysteresis = a; });
    const BuiltRig without = faultless(stiffening_rig());
    const gap_case::Rows rows = pulled(false, gap_case::Side::kAntagonist);
    const std::vector<double> pull = torques(rig, rows), elastic = torques(without, rows);
    for (std::size_t i = 0; i < pull.size(); ++i) {
        const bool top = rows.spring_pull[i].deflection == rows.spring_pull[30].deflection;  // not turned yet
        EXPECT_NEAR(pull[i] / elastic[i], 1.0 + (rows.spring_pull[i].load || top ? a : -a), 1e-12) << i;
    }
    for (const auto& [series, side] : {std::pair{true, gap_case::Side::kAntagonist}, {false, gap_case::Side::kAgonist}})
        EXPECT_EQ(torques(rig, pulled(series, side)), torques(without, pulled(series, side)));
}

TEST(PredictSpringPull, AWiderCapstanDeflectsKSEMoreAndHasTheLongerLever) {
    const double scale = 1.01;
    const BuiltRig rig = built(straight_rig(), [&](BuiltRig& r) {
        for (BuiltSide& side : r.sides) side.capstan_scale = scale;
    });
    const gap_case::Rows series = pulled(true, gap_case::Side::kAgonist), parallel = pulled(false, gap_case::Side::kAgonist);
    const std::vector<double> se = torques(rig, series), pe = torques(rig, parallel);
    for (std::size_t i = 0; i < se.size(); ++i) {
        EXPECT_NEAR(se[i], scale * scale * kSeries * series.spring_pull[i].deflection, 1e-9);
        EXPECT_NEAR(pe[i], kParallel * parallel.spring_pull[i].deflection, 1e-9);  // its cam is its own
    }
}

}  // namespace
}  // namespace fusee::joint_model
