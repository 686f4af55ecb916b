#include <algorithm>
#include <span>

#include "experiments.h"
#include "fusee/gap/motion.h"
#include "reading.h"

namespace fusee::gap {

namespace {

/// One log from rest: its first row's torques are reached in the motors' ramp and settled before it begins.
void follow(const BuiltRig& rig, std::span<const LogRow> rows, const Protocol& protocol, std::vector<double>& read) {
    Motion motion(rig, kLogStep);
    Reading reading(rig);
    const LogRow& first = rows.front();
    motion.lead_to({first.torque_agonist, first.torque_antagonist, first.joint_torque}, protocol.motor_ramp);
    motion.hold(protocol.motor_settle);
    std::size_t next = 0;
    double now = first.time;  // of the commands as they arrive, `delay` late
    for (const LogRow& row : rows) {
        for (; next < rows.size() && rows[next].time + rig.delay <= row.time; ++next) {
            const LogRow& command = rows[next];
            motion.lead_to({command.torque_agonist, command.torque_antagonist, command.joint_torque}, command.time + rig.delay - now);
            now = std::max(now, command.time + rig.delay);
        }
        reading.append(motion, read);
    }
}

}  // namespace

std::vector<double> predict_log(const BuiltRig& rig, const Rows& rows, const Protocol& protocol) {
    std::vector<double> read;
    std::span<const LogRow> left(rows.log);
    const auto parts = rows.parts.find(Experiment::kLog);
    if (parts != rows.parts.end())
        for (const std::size_t count : parts->second) {
            if (count > 0) follow(rig, left.first(count), protocol, read);
            left = left.subspan(count);
        }
    if (!left.empty()) follow(rig, left, protocol, read);
    return read;
}

}  // namespace fusee::gap
