#include "experiments.h"

namespace fusee::gap {

std::vector<double> predict_experiment(const BuiltRig& rig, const Rows& rows, const Protocol& protocol, Experiment experiment) {
    switch (experiment) {
        case Experiment::kBreakAway:
            return predict_break_away(rig, rows.breakaway);
        case Experiment::kSpringPull:
            return predict_spring_pull(rig, rows.spring_pull);
        case Experiment::kDeadBand:
            return predict_dead_band(rig, rows, protocol);
        case Experiment::kJointStiffness:
            return predict_joint_stiffness(rig, rows, protocol);
        case Experiment::kCocontraction:
            return predict_cocontraction(rig, rows, protocol);
        case Experiment::kLog:
            return predict_log(rig, rows, protocol);
    }
    return {};
}

}  // namespace fusee::gap
