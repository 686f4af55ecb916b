#include "session_clock.h"

#include <tuple>
#include <vector>

namespace fusee::joint_model {

namespace {

/// Number of stretches of rows with the same key.
template <class Row, class Key>
double stretches(const std::vector<Row>& rows, const Key& key) {
    double count = rows.empty() ? 0.0 : 1.0;
    for (std::size_t i = 1; i < rows.size(); ++i) count += key(rows[i]) == key(rows[i - 1]) ? 0.0 : 1.0;
    return count;
}

double duration(const gap_case::Rows& rows, const gap_case::Protocol& p, gap_case::Experiment experiment) {
    switch (experiment) {
        case gap_case::Experiment::kBreakAway:
            return static_cast<double>(rows.breakaway.size()) * break_away_time(p);
        case gap_case::Experiment::kSpringPull:
            return p.cocontraction_phase *
                   stretches(rows.spring_pull, [](const auto& row) { return std::tuple(row.series, row.side, row.load); });
        case gap_case::Experiment::kDeadBand:
            return rows.dead_band.empty() ? 0.0 : dead_band_until(rows, p, rows.dead_band.size() - 1);
        case gap_case::Experiment::kJointStiffness:
            return (p.motor_ramp + p.motor_settle) * stretches(rows.joint_stiffness, [](const auto& row) { return row.cocontraction; }) +
                   p.joint_stiffness_phase *
                       stretches(rows.joint_stiffness, [](const auto& row) { return std::tuple(row.cocontraction, row.phase); });
        case gap_case::Experiment::kCocontraction:
            return p.cocontraction_phase * stretches(rows.cocontraction, [](const auto& row) { return row.up; });
        case gap_case::Experiment::kLog:
            return rows.log.empty() ? 0.0 : rows.log.back().time - rows.log.front().time;
    }
    return 0.0;
}

}  // namespace

double dead_band_until(const gap_case::Rows& rows, const gap_case::Protocol& p, std::size_t i) {
    const std::size_t row = rows.dead_band[i].row > 0 ? rows.dead_band[i].row : i + 1;
    return static_cast<double>(row) * (p.motor_ramp + p.motor_settle + 2.0 * (p.dead_band_push + p.dead_band_release));
}

double session_at(const gap_case::Rows& rows, const gap_case::Protocol& protocol, gap_case::Experiment experiment) {
    double begin = 0.0;
    for (const gap_case::Experiment before : gap_case::kAllExperiments) {
        if (before == experiment) break;
        begin += duration(rows, protocol, before);
    }
    return begin;
}

}  // namespace fusee::joint_model
