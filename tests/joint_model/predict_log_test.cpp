#include <gtest/gtest.h>

#include "fusee/joint_model/motion.h"
#include "fusee/joint_model/signals.h"
#include "gap_case/fixture.h"
#include "joint_model/fixture.h"

namespace fusee::joint_model {
namespace {

using namespace fixtures;

const gap_case::CaseTemplate kLogTemplate = small_template();

gap_case::Rows first_rows(std::size_t count) {
    gap_case::Rows rows;
    const std::vector<gap_case::LogRow> all = set_points(kLogTemplate).log;
    rows.log.assign(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count));
    return rows;
}
std::vector<double> read(const BuiltRig& rig, const gap_case::Rows& rows) {
    return predict_experiment(rig, rows, kLogTemplate.protocol, gap_case::Experiment::kLog);
}
BuiltRig delayed(double seconds) {
    return built(kLogTemplate.rig, [&](BuiltRig& r) { r.delay = seconds; });
}

TEST(PredictLog, BeginsCoContractedAtRestAndFollowsItsCommands) {
    const gap_case::Rows rows = first_rows(200);
    const BuiltRig rig = faultless(kLogTemplate.rig);
    const std::vector<double> angles = read(rig, rows);
    Motion motion(rig, step_on(rig.reference, kLogTemplate.protocol, kLogStep));
    const double tau = rows.log[0].torque_agonist;
    motion.lead_to({tau, tau, 0.0}, kLogTemplate.protocol.motor_ramp);
    motion.hold(kLogTemplate.protocol.motor_settle);
    EXPECT_EQ(angles[0], motion.theta(gap_case::Side::kAgonist));
    for (std::size_t i = 1; i < rows.log.size(); ++i) {
        const gap_case::LogRow& row = rows.log[i];
        motion.lead_to({row.torque_agonist, row.torque_antagonist, row.joint_torque}, row.time - rows.log[i - 1].time);
        EXPECT_NEAR(angles[3 * i + 2], motion.q(), 1e-9);
    }
}

TEST(PredictLog, BeginsAsTheMotorRampWasLed) {
    const gap_case::Rows rows = first_rows(2);
    const BuiltRig rig = faultless(kLogTemplate.rig);
    gap_case::Protocol smooth = kLogTemplate.protocol;
    smooth.smooth_motor_ramp = true;
    const std::vector<double> straight = read(rig, rows), led = predict_experiment(rig, rows, smooth, gap_case::Experiment::kLog);
    EXPECT_GT(std::abs(led[0] - straight[0]), 1e-3) << "a gear that is left in another way rests elsewhere";
    EXPECT_NEAR(led[0], straight[0], 0.2 * straight[0]);
    Motion motion(rig, step_on(rig.reference, smooth, kLogStep));
    motion.lead_smoothly_to({rows.log[0].torque_agonist, rows.log[0].torque_antagonist, 0.0}, smooth.motor_ramp);
    motion.hold(smooth.motor_settle);
    EXPECT_EQ(led[0], motion.theta(gap_case::Side::kAgonist));
}

// Not yet: commands are counted as arrived in whole rows, and the motion is read where the last one left it.
TEST(PredictLog, ADelayOfSomeRowsShiftsTheLogByThem) {
    const gap_case::Rows rows = first_rows(250);
    const double step = rows.log[1].time - rows.log[0].time;
    const std::size_t late = 4;
    const std::vector<double> prompt = read(delayed(0.0), rows), shifted = read(delayed(static_cast<double>(late) * step + 1e-9), rows);
    double moved = 0.0;
    for (std::size_t i = 3 * late; i < prompt.size(); ++i) {
        EXPECT_NEAR(shifted[i], prompt[i - 3 * late], 5e-4) << i;  // a nanosecond cuts a step of 0.5 ms in two
        moved = std::max(moved, std::abs(prompt[i] - prompt[i - 3 * late]));
    }
    EXPECT_GT(moved, 0.05);
}

TEST(PredictLog, ADelayOfHalfARowLiesHalfway) {
    const gap_case::Rows rows = first_rows(250);
    const double step = rows.log[1].time - rows.log[0].time;
    const std::vector<double> none = read(delayed(0.0), rows), half = read(delayed(0.5 * step), rows), one = read(delayed(step), rows);
    double sum = 0.0, square = 0.0;  // regression of what half a row does on what one does
    for (std::size_t i = 0; i < none.size(); ++i) {
        sum += (half[i] - none[i]) * (one[i] - none[i]);
        square += (one[i] - none[i]) * (one[i] - none[i]);
    }
    EXPECT_NEAR(sum / square, 0.5, 0.05);
}

TEST(PredictLog, EachPartBeginsAnewAtRest) {
    const gap_case::Rows one = first_rows(300);
    gap_case::Rows two = one;
    two.log.insert(two.log.end(), one.log.begin(), one.log.end());
    two.parts[gap_case::Experiment::kLog] = {300, 300};
    const BuiltRig rig = faultless(kLogTemplate.rig);
    const std::vector<double> alone = read(rig, one), both = read(rig, two);
    ASSERT_EQ(both.size(), 2 * alone.size());
    EXPECT_EQ(std::vector<double>(both.begin(), both.begin() + 900), alone);
    EXPECT_EQ(std::vector<double>(both.begin() + 900, both.end()), alone);
}

TEST(PredictLog, ItsStepIsAccurateEnough) {
    // motion.h: 2 mrad after 8 s of fast motion
    const BuiltRig rig = faultless(kLogTemplate.rig);
    const std::vector<gap_case::LogRow> rows = set_points(kLogTemplate).log;
    std::vector<double> ends;
    for (const double step : {kLogStep, kLogStep / 8.0}) {
        Motion motion(rig, step);
        motion.lead_to({rows[0].torque_agonist, rows[0].torque_antagonist, rows[0].joint_torque}, 1.0);
        for (std::size_t i = 1; i < rows.size() - 1; ++i)
            motion.lead_to({rows[i].torque_agonist, rows[i].torque_antagonist, rows[i].joint_torque}, rows[i].time - rows[i - 1].time);
        ends.push_back(motion.q());
    }
    EXPECT_NEAR(ends[0], ends[1], 2e-3);
}

}  // namespace
}  // namespace fusee::joint_model
