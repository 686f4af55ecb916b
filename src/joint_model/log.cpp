#include <algorithm>
#include <cmath>
#include <span>

#include "experiments.h"
#include "reading.h"

namespace fusee::joint_model {

namespace {

Motion::Torques torques_of(const gap_case::LogRow& row) { return {row.torque_agonist, row.torque_antagonist, row.joint_torque}; }

/// Every third of `read`, q, as it was `lag` before its row.
void delay_q(std::span<const gap_case::LogRow> rows, double lag, std::span<double> read) {
    std::vector<double> q;
    for (std::size_t i = 2; i < read.size(); i += 3) q.push_back(read[i]);
    std::size_t after = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double time = rows[i].time - lag;
        while (after + 1 < rows.size() && rows[after].time < time) ++after;
        const std::size_t before = after > 0 ? after - 1 : 0;
        const double width = rows[after].time - rows[before].time;
        const double share = width > 0.0 ? std::clamp((time - rows[before].time) / width, 0.0, 1.0) : 0.0;
        read[3 * i + 2] = std::lerp(q[before], q[after], share);
    }
}

/// One log from rest: the motor ramp reaches the torques of the first row, which settle before the log begins.
void follow_log(const BuiltRig& rig, std::span<const gap_case::LogRow> rows, const gap_case::Protocol& protocol, double session,
                std::vector<double>& read) {
    Motion motion(rig, step_on(rig.reference, protocol, kLogStep), session);
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
        append_reading(rig, motion, read);
    }
    if (rig.terms.lag > 0.0) delay_q(rows, rig.terms.lag, std::span(read).last(3 * rows.size()));
}

}  // namespace

std::vector<double> predict_log(const BuiltRig& rig, const gap_case::Rows& rows, const gap_case::Protocol& protocol) {
    std::vector<double> read;
    const double session = session_at(rows, protocol, gap_case::Experiment::kLog);
    for (const std::span<const gap_case::LogRow> file : files_of(rows, gap_case::Experiment::kLog, rows.log))
        follow_log(rig, file, protocol, session, read);
    return read;
}

}  // namespace fusee::joint_model
