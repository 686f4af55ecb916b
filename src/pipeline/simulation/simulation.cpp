#include "fusee/pipeline/simulation.h"

namespace fusee::pipeline {

SimulatedLevel unknown_level(double tau) {
    SimulatedLevel level;
    level.dead_band.tau = level.reading.tau = tau;
    for (double* figure :
         {&level.dead_band.linear, &level.dead_band.exact_width, &level.dead_band.measured_width, &level.dead_band.joint_stiffness,
          &level.dead_band.free_joint_stiffness, &level.dead_band.theta, &level.dead_band.condition_6, &level.reading.push_torque,
          &level.reading.full_push, &level.reading.covered_push, &level.reading.q_low, &level.reading.q_high})
        *figure = kUnknown;
    level.dead_band.covered = level.reading.inside = false;
    level.sensitivity.setConstant(kUnknown);
    level.noise.setConstant(kUnknown);
    return level;
}

actuator::ArrangementRow unknown_survey() {
    constexpr core::Range kNone{kUnknown, kUnknown};
    return {.stiffness = kNone, .free_stiffness = kNone, .torque = kUnknown, .dead_band = kNone, .remark = ""};
}

core::Findings refusals(const Simulation& simulation) {
    core::Findings all;
    for (const EquilibriumRow& row : simulation.equilibria) core::append(all, row.refusal);
    return all;
}

}  // namespace fusee::pipeline
