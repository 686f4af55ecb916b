#include <algorithm>
#include <cmath>
#include <span>

#include "experiments.h"
#include "reading.h"

namespace fusee::joint_model {

namespace {

Motion::Torques torques_of(const gap_case::LogRow& row) { return {row.torque_agonist, row.torque_antagonist, row.joint_torque}; }

/// One log from rest: the motor ramp reaches the torques of the first row, which settle before the log begins.
void follow(const BuiltRig& rig, std::span<const gap_case::LogRow> rows, const gap_case::Protocol& protocol, std::vector<double>& read) {
    Motion motion(rig, step_on(rig.reference, protocol, kLogStep));
    Reading reading(rig);
    const gap_case::LogRow& first = rows.front();
    begin_at(motion, torques_of(first), protocol);
    std::size_t next = 1;
    double now = first.time;  // commands after the `delay`
    const auto lead_to = [&](const Motion::Torques& command, double time) {
        motion.lead_to(command, time - now);
        now = time;
    };
    for (const gap_case::LogRow& row : rows) {
        const double sent = row.time - rig.delay;  // command that acts at this row
        for (; next < rows.size() && rows[next].time <= sent; ++next)
            if (rows[next].time > now) lead_to(torques_of(rows[next]), rows[next].time);
        if (sent > now && next < rows.size()) {
            const gap_case::LogRow &before = rows[next - 1], &after = rows[next];
            const double share = (sent - before.time) / (after.time - before.time);
            lead_to({std::lerp(before.torque_agonist, after.torque_agonist, share),
                     std::lerp(before.torque_antagonist, after.torque_antagonist, share),
                     std::lerp(before.joint_torque, after.joint_torque, share)},
                    sent);
        }
        reading.append(motion, read);
    }
}

}  // namespace

std::vector<double> predict_log(const BuiltRig& rig, const gap_case::Rows& rows, const gap_case::Protocol& protocol) {
    std::vector<double> read;
    for (const std::span<const gap_case::LogRow> file : files_of(rows, gap_case::Experiment::kLog, rows.log))
        follow(rig, file, protocol, read);
    return read;
}

}  // namespace fusee::joint_model
