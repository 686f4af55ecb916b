#pragma once
#include <vector>

#include "fusee/gap/motion.h"
#include "fusee/gap/signals.h"

/// One prediction an experiment, each in a file of its own.
namespace fusee::gap {

/// From rest to the torques that an experiment begins with, as the protocol says, settled.
inline void begin_at(Motion& motion, const Motion::Torques& torques, const Protocol& protocol) {
    if (protocol.smooth_motor_ramp)
        motion.lead_smoothly_to(torques, protocol.motor_ramp);
    else
        motion.lead_to(torques, protocol.motor_ramp);
    motion.hold(protocol.motor_settle);
}

[[nodiscard]] std::vector<double> predict_break_away(const BuiltRig& rig, const std::vector<BreakAway>& rows);
[[nodiscard]] std::vector<double> predict_spring_pull(const BuiltRig& rig, const std::vector<SpringPull>& rows);
[[nodiscard]] std::vector<double> predict_dead_band(const BuiltRig& rig, const Rows& rows, const Protocol& protocol);
[[nodiscard]] std::vector<double> predict_joint_stiffness(const BuiltRig& rig, const std::vector<StiffnessRow>& rows,
                                                          const Protocol& protocol);
[[nodiscard]] std::vector<double> predict_cocontraction(const BuiltRig& rig, const std::vector<CocontractionRow>& rows,
                                                        const Protocol& protocol);
[[nodiscard]] std::vector<double> predict_log(const BuiltRig& rig, const Rows& rows, const Protocol& protocol);

}  // namespace fusee::gap
