#include <algorithm>
#include <cmath>

#include "experiments.h"
#include "reading.h"

namespace fusee::joint_model {

namespace {

/// One file from rest. The greatest torque of all files takes one phase.
void follow_cocontraction(const BuiltRig& rig, std::span<const gap_case::CocontractionRow> rows, double seconds_per_torque, Motion motion,
                          std::vector<double>& read) {
    double torque = 0.0;
    for (const gap_case::CocontractionRow& row : rows) {
        motion.lead_to({row.motor_torque, row.motor_torque, 0.0}, seconds_per_torque * std::abs(row.motor_torque - torque));
        torque = row.motor_torque;
        append_reading(rig, motion, read);
    }
}

}  // namespace

std::vector<double> predict_cocontraction(const BuiltRig& rig, const gap_case::Rows& rows, const gap_case::Protocol& protocol) {
    double most = 1e-9 * rig.reference.torque;
    for (const gap_case::CocontractionRow& row : rows.cocontraction) most = std::max(most, std::abs(row.motor_torque));
    std::vector<double> read;
    const Motion at_rest(rig, step_on(rig.reference, protocol, kSlowStep),
                         session_at(rows, protocol, gap_case::Experiment::kCocontraction));
    for (const std::span<const gap_case::CocontractionRow> file : files_of(rows, gap_case::Experiment::kCocontraction, rows.cocontraction))
        follow_cocontraction(rig, file, protocol.cocontraction_phase / most, at_rest, read);
    return read;
}

}  // namespace fusee::joint_model
