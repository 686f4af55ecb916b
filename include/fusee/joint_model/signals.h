#pragma once
#include <array>
#include <span>
#include <vector>

#include "fusee/gap_case/case.h"
#include "fusee/joint_model/built_rig.h"

namespace fusee::joint_model {

/// The measured columns of every experiment, row by row: entry row * columns + column of of[experiment].
struct Signals {
    std::array<std::vector<double>, gap_case::kExperiments> of;
    [[nodiscard]] std::vector<double>& operator[](gap_case::Experiment e) { return of[static_cast<int>(e)]; }
    [[nodiscard]] const std::vector<double>& operator[](gap_case::Experiment e) const { return of[static_cast<int>(e)]; }
};

/// Names of the measured columns: {"load_torque_Nm"}, {"q_low_rad", "q_high_rad"}, ...
[[nodiscard]] std::vector<std::string> measured_columns(gap_case::Experiment experiment, const gap_case::Rows& rows);
/// The measured values of the rows; the rows with `signals` as measured values.
[[nodiscard]] Signals measured(const gap_case::Rows& rows);
[[nodiscard]] gap_case::Rows with_measured(const gap_case::Rows& rows, const Signals& signals);

/// Prediction for a built rig at the inputs of `rows`. All experiments with motion are integrated in time (motion.h).
[[nodiscard]] std::vector<double> predict_experiment(const BuiltRig& rig, const gap_case::Rows& rows, const gap_case::Protocol& protocol,
                                                     gap_case::Experiment experiment);
/// The same of several rigs of one case, four at a time: each has the bits that it has alone.
[[nodiscard]] std::vector<std::vector<double>> predict_experiment(std::span<const BuiltRig> rigs, const gap_case::Rows& rows,
                                                                  const gap_case::Protocol& protocol, gap_case::Experiment experiment);
[[nodiscard]] Signals predict_signals(const BuiltRig& rig, const gap_case::Rows& rows, const gap_case::Protocol& protocol);

}  // namespace fusee::joint_model
