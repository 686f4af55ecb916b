#include "fusee/gap/signals.h"

namespace fusee::gap {

namespace {

/// Calls visit(experiment, figure) for every measured figure, in the order of Signals.
template <typename AnyRows, typename Visit>
void visit_measured(AnyRows& rows, const Visit& visit) {
    for (auto& row : rows.breakaway) visit(Experiment::kBreakAway, row.load_torque);
    for (auto& row : rows.spring_pull) visit(Experiment::kSpringPull, row.torque);
    for (auto& row : rows.dead_band) {
        if (rows.dead_band_width_only) {
            visit(Experiment::kDeadBand, row.width);
            continue;
        }
        visit(Experiment::kDeadBand, row.q_low);
        visit(Experiment::kDeadBand, row.q_high);
    }
    for (auto& row : rows.joint_stiffness) visit(Experiment::kJointStiffness, row.q);
    for (auto& row : rows.cocontraction) {
        visit(Experiment::kCocontraction, row.theta_agonist);
        visit(Experiment::kCocontraction, row.theta_antagonist);
        visit(Experiment::kCocontraction, row.q);
    }
    for (auto& row : rows.log) {
        visit(Experiment::kLog, row.theta_agonist);
        visit(Experiment::kLog, row.theta_antagonist);
        visit(Experiment::kLog, row.q);
    }
}

}  // namespace

std::vector<std::string> measured_columns(Experiment experiment, const Rows& rows) {
    switch (experiment) {
        case Experiment::kBreakAway:
            return {"load_torque_Nm"};
        case Experiment::kSpringPull:
            return {"torque_Nm"};
        case Experiment::kDeadBand:
            if (rows.dead_band_width_only) return {"width_rad"};
            return {"q_low_rad", "q_high_rad"};
        case Experiment::kJointStiffness:
            return {"q_rad"};
        default:
            return {"theta_agonist_rad", "theta_antagonist_rad", "q_rad"};
    }
}

Signals measured(const Rows& rows) {
    Signals signals;
    visit_measured(rows, [&](Experiment experiment, double figure) { signals[experiment].push_back(figure); });
    return signals;
}

Rows with_measured(const Rows& rows, const Signals& signals) {
    Rows filled = rows;
    std::array<std::size_t, kExperiments> next{};
    visit_measured(filled,
                   [&](Experiment experiment, double& figure) { figure = signals[experiment].at(next[static_cast<int>(experiment)]++); });
    for (DeadBandRow& row : filled.dead_band)
        if (!filled.dead_band_width_only) row.width = row.q_high - row.q_low;
    return filled;
}

Signals predict_signals(const BuiltRig& rig, const Rows& rows, const Protocol& protocol) {
    Signals signals;
    for (const Experiment experiment : kAllExperiments) signals[experiment] = predict_experiment(rig, rows, protocol, experiment);
    return signals;
}

}  // namespace fusee::gap
