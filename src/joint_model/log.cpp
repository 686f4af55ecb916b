#include <algorithm>
#include <cmath>
#include <span>

#include "experiments.h"

namespace fusee::joint_model {

namespace {

template <class V>
typename MotionOf<V>::Torques torques_of(double agonist, double antagonist, double joint) {
    return {in_all<V>(agonist), in_all<V>(antagonist), in_all<V>(joint)};
}
template <class V>
typename MotionOf<V>::Torques torques_of(const gap_case::LogRow& row) {
    return torques_of<V>(row.torque_agonist, row.torque_antagonist, row.joint_torque);
}

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
template <class V>
void follow_log(const RigsOf<V>& rigs, std::span<const gap_case::LogRow> rows, const gap_case::Protocol& protocol, double session,
                ReadingsOf<V>& read) {
    MotionOf<V> motion(rigs, step_on(rigs[0]->reference, protocol, kLogStep), in_all<V>(session));
    const gap_case::LogRow& first = rows.front();
    begin_at(motion, torques_of<V>(first), protocol);
    std::size_t next = 1;
    double now = first.time;  // commands after the `delay`
    const auto lead_to = [&](const typename MotionOf<V>::Torques& command, double time) {
        motion.lead_to(command, in_all<V>(time - now));
        now = time;
    };
    for (const gap_case::LogRow& row : rows) {
        const double sent = row.time - rigs[0]->delay;  // command that acts at this row
        for (; next < rows.size() && rows[next].time <= sent; ++next)
            if (rows[next].time > now) lead_to(torques_of<V>(rows[next]), rows[next].time);
        if (sent > now && next < rows.size()) {
            const gap_case::LogRow &before = rows[next - 1], &after = rows[next];
            const double share = (sent - before.time) / (after.time - before.time);
            lead_to(torques_of<V>(std::lerp(before.torque_agonist, after.torque_agonist, share),
                                  std::lerp(before.torque_antagonist, after.torque_antagonist, share),
                                  std::lerp(before.joint_torque, after.joint_torque, share)),
                    sent);
        }
        append_reading(motion, read);
    }
    for (std::size_t i = 0; i < read.size(); ++i)
        if (rigs[i]->terms.lag > 0.0) delay_q(rows, rigs[i]->terms.lag, std::span(read[i]).last(3 * rows.size()));
}

}  // namespace

template <class V>
ReadingsOf<V> predict_log(const RigsOf<V>& rigs, const gap_case::Rows& rows, const gap_case::Protocol& protocol) {
    ReadingsOf<V> read;
    const double session = session_at(rows, protocol, gap_case::Experiment::kLog);
    for (const std::span<const gap_case::LogRow> file : files_of(rows, gap_case::Experiment::kLog, rows.log))
        follow_log<V>(rigs, file, protocol, session, read);
    return read;
}

template ReadingsOf<double> predict_log<double>(const RigsOf<double>&, const gap_case::Rows&, const gap_case::Protocol&);
template ReadingsOf<Lanes> predict_log<Lanes>(const RigsOf<Lanes>&, const gap_case::Rows&, const gap_case::Protocol&);

}  // namespace fusee::joint_model
