#include "fusee/joint_model/signals.h"

namespace fusee::joint_model {

namespace {

/// Calls visit(experiment, figure) for every measured figure, in the order of Signals.
template <typename AnyRows, typename Visit>
void visit_measured(AnyRows& rows, const Visit& visit) {
    for (auto& row : rows.breakaway) visit(gap_case::Experiment::kBreakAway, row.load_torque);
    for (auto& row : rows.spring_pull) visit(gap_case::Experiment::kSpringPull, row.torque);
    for (auto& row : rows.dead_band) {
        if (rows.dead_band_width_only) {
            visit(gap_case::Experiment::kDeadBand, row.width);
            continue;
        }
        visit(gap_case::Experiment::kDeadBand, row.q_low);
        visit(gap_case::Experiment::kDeadBand, row.q_high);
    }
    for (auto& row : rows.joint_stiffness) visit(gap_case::Experiment::kJointStiffness, row.q);
    for (auto& row : rows.cocontraction) {
        visit(gap_case::Experiment::kCocontraction, row.theta_agonist);
        visit(gap_case::Experiment::kCocontraction, row.theta_antagonist);
        visit(gap_case::Experiment::kCocontraction, row.q);
    }
    for (auto& row : rows.log) {
        visit(gap_case::Experiment::kLog, row.theta_agonist);
        visit(gap_case::Experiment::kLog, row.theta_antagonist);
        visit(gap_case::Experiment::kLog, row.q);
    }
}

}  // namespace

std::vector<std::string> measured_columns(gap_case::Experiment experiment, const gap_case::Rows& rows) {
    switch (experiment) {
        case gap_case::Experiment::kBreakAway:
            return {"load_torque_Nm"};
        case gap_case::Experiment::kSpringPull:
            return {"torque_Nm"};
        case gap_case::Experiment::kDeadBand:
            if (rows.dead_band_width_only) return {"width_rad"};
            return {"q_low_rad", "q_high_rad"};
        case gap_case::Experiment::kJointStiffness:
            return {"q_rad"};
        default:
            return {"theta_agonist_rad", "theta_antagonist_rad", "q_rad"};
    }
}

Signals measured(const gap_case::Rows& rows) {
    Signals signals;
    visit_measured(rows, [&](gap_case::Experiment experiment, double figure) { signals[experiment].push_back(figure); });
    return signals;
}

gap_case::Rows with_measured(const gap_case::Rows& rows, const Signals& signals) {
    gap_case::Rows filled = rows;
    std::array<std::size_t, gap_case::kExperiments> next{};
    visit_measured(filled, [&](gap_case::Experiment experiment, double& figure) {
        figure = signals[experiment].at(next[static_cast<int>(experiment)]++);
    });
    for (gap_case::DeadBandRow& row : filled.dead_band)
        if (!filled.dead_band_width_only) row.width = row.q_high - row.q_low;
    return filled;
}

Signals predict_signals(const BuiltRig& rig, const gap_case::Rows& rows, const gap_case::Protocol& protocol) {
    Signals signals;
    for (const gap_case::Experiment experiment : gap_case::kAllExperiments)
        signals[experiment] = predict_experiment(rig, rows, protocol, experiment);
    return signals;
}

}  // namespace fusee::joint_model
