#include "workload.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "fusee/core/error.h"
#include "fusee/joint_model/motion.h"

namespace fusee::diagnosis {

namespace {

/// Each change of co-contraction begins from rest; each row takes at least one step.
double stiffness_steps(const std::vector<gap_case::StiffnessRow>& rows, const gap_case::Protocol& p, double step) {
    double seconds = 0.0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const bool rest = i == 0 || rows[i].cocontraction != rows[i - 1].cocontraction;
        if (rest) seconds += p.motor_ramp + p.motor_settle;
        if (rest || rows[i].phase != rows[i - 1].phase) seconds += p.joint_stiffness_phase;
    }
    return seconds / step + static_cast<double>(rows.size());
}

double cocontraction_steps(const std::vector<gap_case::CocontractionRow>& rows, const gap_case::Protocol& p, double step) {
    double most = std::numeric_limits<double>::min(), way = 0.0, torque = 0.0;
    for (const gap_case::CocontractionRow& row : rows) {
        most = std::max(most, std::abs(row.motor_torque));
        way += std::abs(row.motor_torque - torque);
        torque = row.motor_torque;
    }
    return way / most * p.cocontraction_phase / step + static_cast<double>(rows.size());
}

double log_steps(const std::vector<gap_case::LogRow>& rows, const gap_case::Protocol& p, double step) {
    double seconds = rows.empty() ? 0.0 : p.motor_ramp + p.motor_settle;
    for (std::size_t i = 1; i < rows.size(); ++i) seconds += std::max(0.0, rows[i].time - rows[i - 1].time);
    return seconds / step + static_cast<double>(rows.size());
}

}  // namespace

std::array<double, gap_case::kExperiments> motion_steps(const gap_case::NominalRig& rig, const gap_case::Rows& rows,
                                                            const gap_case::Protocol& p) {
    const gap_case::Reference reference = gap_case::reference_of(rig);
    const double slow = joint_model::step_on(reference, p, joint_model::kSlowStep), log = joint_model::step_on(reference, p, joint_model::kLogStep);
    std::array<double, gap_case::kExperiments> steps{};
    const double test = p.motor_ramp + p.motor_settle + 2.0 * (p.dead_band_push + p.dead_band_release);
    steps[static_cast<std::size_t>(gap_case::Experiment::kDeadBand)] =
        static_cast<double>(rows.dead_band.size()) * test / joint_model::step_on(reference, p, joint_model::kDeadBandStep);
    steps[static_cast<std::size_t>(gap_case::Experiment::kJointStiffness)] = stiffness_steps(rows.joint_stiffness, p, slow);
    steps[static_cast<std::size_t>(gap_case::Experiment::kCocontraction)] = cocontraction_steps(rows.cocontraction, p, slow);
    steps[static_cast<std::size_t>(gap_case::Experiment::kLog)] = log_steps(rows.log, p, log);
    return steps;
}

void require_feasible(const gap_case::NominalRig& rig, const gap_case::Rows& rows, const gap_case::Protocol& protocol, double most) {
    const std::array<double, gap_case::kExperiments> steps = motion_steps(rig, rows, protocol);
    const double all = std::accumulate(steps.begin(), steps.end(), 0.0);
    if (all <= most) return;
    const auto longest = static_cast<std::size_t>(std::max_element(steps.begin(), steps.end()) - steps.begin());
    const auto experiment = static_cast<gap_case::Experiment>(longest);
    const char* const hint =
        experiment == gap_case::Experiment::kJointStiffness
            ? "; each change of cocontraction_Nm begins a loop from rest: does the column hold the commands, with rows in order?"
            : "; leave out repeats, or put them into a separate case";
    throw core::InvalidInput(
        fmt::format("experiments.{}", to_string(experiment)),
        fmt::format("{} rows with a motion {:.3g} times as long as in a usual case", rows.size(experiment), steps[longest] / kUsualSteps),
        fmt::format("at most {:.3g} times in all{}", most / kUsualSteps, hint));
}

}  // namespace fusee::diagnosis
