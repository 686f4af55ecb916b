#include "experiments.h"

namespace fusee::joint_model {

std::vector<double> predict_experiment(const BuiltRig& rig, const gap_case::Rows& rows, const gap_case::Protocol& protocol,
                                       gap_case::Experiment experiment) {
    switch (experiment) {
        case gap_case::Experiment::kBreakAway:
            return predict_break_away(rig, rows.breakaway, protocol);
        case gap_case::Experiment::kSpringPull:
            return predict_spring_pull(rig, rows.spring_pull, protocol);
        case gap_case::Experiment::kDeadBand:
            return predict_dead_band(rig, rows, protocol);
        case gap_case::Experiment::kJointStiffness:
            return predict_joint_stiffness(rig, rows, protocol);
        case gap_case::Experiment::kCocontraction:
            return predict_cocontraction(rig, rows, protocol);
        case gap_case::Experiment::kLog:
            return predict_log(rig, rows, protocol);
    }
    return {};
}

}  // namespace fusee::joint_model
