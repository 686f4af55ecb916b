#pragma once
#include <span>
#include <vector>

#include "fusee/joint_model/motion.h"
#include "fusee/joint_model/signals.h"
#include "reading.h"
#include "session_clock.h"

/// One prediction per experiment, each in its file.
namespace fusee::joint_model {

/// Leads the motion from rest to the first torques of an experiment by the protocol, then settling.
template <class V>
void begin_at(MotionOf<V>& motion, const typename MotionOf<V>::Torques& torques, const gap_case::Protocol& protocol) {
    if (protocol.smooth_motor_ramp)
        motion.lead_smoothly_to(torques, in_all<V>(protocol.motor_ramp));
    else
        motion.lead_to(torques, in_all<V>(protocol.motor_ramp));
    motion.hold(in_all<V>(protocol.motor_settle));
}

/// The rows of each file of an experiment: each begins from rest. Rows beyond the files are one more part.
template <class Row>
[[nodiscard]] std::vector<std::span<const Row>> files_of(const gap_case::Rows& rows, gap_case::Experiment experiment,
                                                         const std::vector<Row>& all) {
    std::vector<std::span<const Row>> files;
    std::span<const Row> left(all);
    const auto parts = rows.parts.find(experiment);
    if (parts != rows.parts.end())
        for (const std::size_t count : parts->second) {
            if (count > 0) files.push_back(left.first(count));
            left = left.subspan(count);
        }
    if (!left.empty()) files.push_back(left);
    return files;
}

[[nodiscard]] std::vector<double> predict_break_away(const BuiltRig& rig, const std::vector<gap_case::BreakAway>& rows,
                                                     const gap_case::Protocol& protocol);
/// A spring that relaxes or drifts needs times, which the rows do not have: loading or unloading takes one phase of a co-contraction.
[[nodiscard]] std::vector<double> predict_spring_pull(const BuiltRig& rig, const gap_case::Rows& rows, const gap_case::Protocol& protocol);
// Of one rig, or of four of one case: V = double or Lanes. @pre four rigs of a log have the same delay
template <class V>
[[nodiscard]] ReadingsOf<V> predict_dead_band(const RigsOf<V>& rigs, const gap_case::Rows& rows, const gap_case::Protocol& protocol);
template <class V>
[[nodiscard]] ReadingsOf<V> predict_joint_stiffness(const RigsOf<V>& rigs, const gap_case::Rows& rows, const gap_case::Protocol& protocol);
template <class V>
[[nodiscard]] ReadingsOf<V> predict_cocontraction(const RigsOf<V>& rigs, const gap_case::Rows& rows, const gap_case::Protocol& protocol);
template <class V>
[[nodiscard]] ReadingsOf<V> predict_log(const RigsOf<V>& rigs, const gap_case::Rows& rows, const gap_case::Protocol& protocol);

}  // namespace fusee::joint_model
