#pragma once
#include <vector>

#include "fusee/gap_case/case.h"
#include "fusee/joint_model/built_rig.h"

/// Predictions that need no motion, and the times of a session. A case states none, so it is taken to make its experiments in the order of
/// the format, without pauses.
namespace fusee::joint_model {

/// Beginning of an experiment [s].
[[nodiscard]] double session_at(const gap_case::Rows& rows, const gap_case::Protocol& protocol, gap_case::Experiment experiment);

/// One break-away test: a ramp of the motor, its settling, and twice as long for the load that moves it [s].
[[nodiscard]] inline double break_away_time(const gap_case::Protocol& p) { return 3.0 * (p.motor_ramp + p.motor_settle); }
/// Time from the beginning of the dead-band's table to the end of row `i`: each is co-contracted, pushed and released both ways [s].
[[nodiscard]] double dead_band_until(const gap_case::Rows& rows, const gap_case::Protocol& protocol, std::size_t i);

[[nodiscard]] std::vector<double> predict_break_away(const BuiltRig& rig, const std::vector<gap_case::BreakAway>& rows,
                                                     const gap_case::Protocol& protocol);
/// A spring that relaxes or drifts needs times, which the rows do not have: loading or unloading takes one phase of a co-contraction.
[[nodiscard]] std::vector<double> predict_spring_pull(const BuiltRig& rig, const gap_case::Rows& rows, const gap_case::Protocol& protocol);

}  // namespace fusee::joint_model
