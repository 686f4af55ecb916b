#include <algorithm>
#include <cmath>

#include "experiments.h"
#include "reading.h"

namespace fusee::gap {

namespace {

/// One file, from rest, at the speed that makes the greatest torque of all files last a phase.
void follow(const BuiltRig& rig, std::span<const CocontractionRow> rows, double seconds_per_torque, std::vector<double>& read) {
    Motion motion(rig, kSlowStep);
    Reading reading(rig);
    double torque = 0.0;
    for (const CocontractionRow& row : rows) {
        motion.lead_to({row.motor_torque, row.motor_torque, 0.0}, seconds_per_torque * std::abs(row.motor_torque - torque));
        torque = row.motor_torque;
        reading.append(motion, read);
    }
}

}  // namespace

std::vector<double> predict_cocontraction(const BuiltRig& rig, const Rows& rows, const Protocol& protocol) {
    double most = 1e-9;
    for (const CocontractionRow& row : rows.cocontraction) most = std::max(most, std::abs(row.motor_torque));
    std::vector<double> read;
    for (const std::span<const CocontractionRow> file : files_of(rows, Experiment::kCocontraction, rows.cocontraction))
        follow(rig, file, protocol.cocontraction_phase / most, read);
    return read;
}

}  // namespace fusee::gap
