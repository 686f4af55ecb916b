#include <algorithm>
#include <cmath>

#include "fusee/core/error.h"
#include "fusee/gap_case/case_template.h"
#include "fusee/gap_case/reference.h"

namespace fusee::gap_case {

namespace {

constexpr double kEmpty = std::numeric_limits<double>::quiet_NaN();
constexpr int kRepeats = 3, kBreakAwayRepeats = 4;

/// Rounded to four decimals of `unit`: a person has to set them.
double rounded(double value, double unit = 1.0) {
    const double digit = 1e4 / unit;
    return std::round(value * digit) / digit;
}
double rounded_torque(const CaseTemplate& t, double torque) { return rounded(torque, reference_of(t.rig).decade()); }

/// `count` set points from low to high, both included.
std::vector<double> levels(core::Range range, std::size_t count, double unit = 1.0) {
    std::vector<double> all(count);
    for (std::size_t i = 0; i < count; ++i)
        all[i] = rounded(range.low + range.width() * static_cast<double>(i) / static_cast<double>(count - 1), unit);
    return all;
}
std::vector<double> torque_levels(const CaseTemplate& t, core::Range range, std::size_t count) {
    return levels(range, count, reference_of(t.rig).decade());
}

std::vector<double> back(std::vector<double> levels) {
    std::reverse(levels.begin(), levels.end());
    return levels;
}

/// Greatest joint torque of the stiffness loops: its share at the capstan stays within the range of K_SE.
double joint_torque(const CaseTemplate& t) {
    constexpr double kShare = 0.6;
    return rounded_torque(t, t.rig.ratio() * kShare * std::min(t.torques.high, t.rig.springs.back().se_torque));
}

std::vector<BreakAway> breakaway(const CaseTemplate& t) {
    constexpr std::size_t kLevels = 6;
    std::vector<BreakAway> rows;
    for (const Side side : {Side::kAgonist, Side::kAntagonist})
        for (const bool backdrive : {true, false})
            for (const double torque : torque_levels(t, t.torques, kLevels))
                for (int i = 0; i < kBreakAwayRepeats; ++i) rows.push_back({to_string(side), backdrive, torque, kEmpty});
    return rows;
}

std::vector<SpringPull> spring_pull(const CaseTemplate& t) {
    constexpr std::size_t kLevels = 31;
    constexpr double kReach = 0.95;  // of the springs' range: the end is their stop
    const core::Range range{t.rest_deflection, t.rest_deflection + kReach * (t.rig.springs.back().deflection - t.rest_deflection)};
    const std::vector<double> up = levels(range, kLevels);
    std::vector<SpringPull> rows;
    for (const bool series : {true, false})
        for (const Side side : {Side::kAgonist, Side::kAntagonist})
            for (const bool load : {true, false})
                for (const double deflection : load ? up : back(up)) rows.push_back({series, side, load, deflection, kEmpty});
    return rows;
}

/// A push that leaves the dead-band, which grows with the co-contraction, within the curve of K_SE.
double push_torque(const CaseTemplate& t, double cocontraction) {
    if (const double push = t.push ? t.push(cocontraction).torque : 0.0; push > 0.0) return rounded_torque(t, push);
    constexpr double kConstant = 0.4, kGrowth = 0.8, kReach = 0.9;
    const double carried = kReach * t.rig.springs.back().se_torque;
    return rounded_torque(t, t.rig.ratio() * std::min(kConstant * t.torques.high + kGrowth * cocontraction, carried));
}

std::vector<DeadBandRow> dead_band(const CaseTemplate& t) {
    constexpr std::size_t kLevels = 7;
    std::vector<DeadBandRow> rows;
    for (const double torque : torque_levels(t, t.torques, kLevels)) {
        const double push = push_torque(t, torque);
        for (int repeat = 1; repeat <= kRepeats; ++repeat) rows.push_back({torque, repeat, push, kEmpty, kEmpty, kEmpty});
    }
    return rows;
}

std::vector<StiffnessRow> joint_stiffness(const CaseTemplate& t) {
    constexpr std::size_t kLevels = 3, kSteps = 25;
    const double most = joint_torque(t);
    std::vector<StiffnessRow> rows;
    for (const double torque : torque_levels(t, t.torques, kLevels))
        for (const auto phase :
             {StiffnessPhase::kLoadUp, StiffnessPhase::kUnloadUp, StiffnessPhase::kLoadDown, StiffnessPhase::kUnloadDown}) {
            const bool up = phase == StiffnessPhase::kLoadUp || phase == StiffnessPhase::kUnloadUp;
            const bool load = phase == StiffnessPhase::kLoadUp || phase == StiffnessPhase::kLoadDown;
            const std::vector<double> steps = torque_levels(t, {0.0, up ? most : -most}, kSteps);
            for (const double joint : load ? steps : back(steps)) rows.push_back({torque, phase, joint, kEmpty});
        }
    return rows;
}

std::vector<CocontractionRow> cocontraction(const CaseTemplate& t) {
    constexpr std::size_t kSteps = 51;
    const core::Range range{t.rest_deflection > 0.0 ? t.torques.low : 0.0, t.torques.high};
    std::vector<CocontractionRow> rows;
    for (const bool up : {true, false})
        for (const double torque : up ? torque_levels(t, range, kSteps) : back(torque_levels(t, range, kSteps)))
            rows.push_back({up, torque, kEmpty, kEmpty, kEmpty});
    return rows;
}

/// Three parts, each beginning and ending at rest: the motors against each other, both together, the joint pushed.
std::vector<LogRow> log(const CaseTemplate& t) {
    constexpr double kPart = 3.0, kShare = 0.3;  // [s]; of the torques' width
    const double middle = 0.5 * (t.torques.low + t.torques.high), swing = kShare * t.torques.width();
    std::vector<LogRow> rows;
    const auto count = static_cast<std::size_t>(3.0 * kPart * t.sensors.log_rate);
    for (std::size_t i = 0; i < count; ++i) {
        const double time = static_cast<double>(i) / t.sensors.log_rate;
        const int part = std::min(2, static_cast<int>(time / kPart));
        const double phase = 2.0 * core::kPi * (time / kPart - part);
        const double apart = part == 0 ? swing * std::sin(2.0 * phase) : 0.0, together = part == 1 ? swing * std::sin(phase) : 0.0;
        const double joint = part == 2 ? 0.5 * joint_torque(t) * std::sin(2.0 * phase) : 0.0;
        rows.push_back({time, rounded_torque(t, middle + apart + together), rounded_torque(t, middle - apart + together),
                        rounded_torque(t, joint), kEmpty, kEmpty, kEmpty});
    }
    return rows;
}

}  // namespace

Rows set_points(const CaseTemplate& empty) {
    if (!(empty.torques.low >= 0.0 && empty.torques.low < empty.torques.high))
        throw core::InvalidInput("torques", "no range", "a least co-contraction of at least 0 Nm below the greatest");
    if (empty.rig.springs.empty()) throw core::InvalidInput("rig.springs", "no rows", "the springs' torques over deflection");
    Rows rows;
    rows.breakaway = breakaway(empty);
    rows.spring_pull = spring_pull(empty);
    rows.dead_band = dead_band(empty);
    rows.joint_stiffness = joint_stiffness(empty);
    rows.cocontraction = cocontraction(empty);
    rows.log = log(empty);
    return rows;
}

}  // namespace fusee::gap_case
