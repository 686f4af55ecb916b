#pragma once
#include <array>
#include <vector>

#include "fusee/gap/built_rig.h"
#include "fusee/gap/case.h"

namespace fusee::gap {

/// The measured columns of every experiment, row by row: entry row * columns + column of of[experiment].
struct Signals {
    std::array<std::vector<double>, kExperiments> of;
    [[nodiscard]] std::vector<double>& operator[](Experiment e) { return of[static_cast<int>(e)]; }
    [[nodiscard]] const std::vector<double>& operator[](Experiment e) const { return of[static_cast<int>(e)]; }
};

/// Names of the measured columns: {"load_torque_Nm"}, {"q_low_rad", "q_high_rad"}, ...
[[nodiscard]] std::vector<std::string> measured_columns(Experiment experiment, const Rows& rows);
/// What stands in the rows, and the rows with `signals` put in its place.
[[nodiscard]] Signals measured(const Rows& rows);
[[nodiscard]] Rows with_measured(const Rows& rows, const Signals& signals);

/// What a built rig gives at the inputs of `rows`. Slow experiments and log alike are integrated in time (motion.h).
[[nodiscard]] std::vector<double> predict_experiment(const BuiltRig& rig, const Rows& rows, const Protocol& protocol,
                                                     Experiment experiment);
[[nodiscard]] Signals predict_signals(const BuiltRig& rig, const Rows& rows, const Protocol& protocol);

}  // namespace fusee::gap
