#include "data/csv.h"

#include "fusee/report/simulation.h"

namespace fusee::report {

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

std::string dead_band_csv(const std::vector<SimulatedLevel>& levels) {
    std::string csv = "tau_Nm,linear_rad,extreme_rad,protocol_rad,condition_6,joint_stiffness_Nm_per_rad,capstan_rad\n";
    for (const SimulatedLevel& level : levels) {
        const actuator::DeadBand& d = level.dead_band;
        add_csv_row(csv, d.tau, d.linear, d.exact_width, d.measured_width, d.condition_6, d.joint_stiffness, d.theta);
    }
    return csv;
}

std::string relatives_csv(const std::vector<Simulation>& simulations) {
    std::string csv =
        "name,arrangement,stiffness_low_Nm_per_rad,stiffness_high_Nm_per_rad,free_stiffness_low_Nm_per_rad,free_stiffness_high_Nm_per_rad,"
        "torque_Nm,dead_band_low_rad,dead_band_high_rad\n";
    for (const Simulation& simulation : simulations) {
        const actuator::ArrangementRow& row = simulation.survey;
        add_csv_row(csv, simulation.provenance.name, to_string(row.arrangement), row.stiffness.low, row.stiffness.high,
                    row.free_stiffness.low, row.free_stiffness.high, row.torque, row.dead_band.low, row.dead_band.high);
    }
    return csv;
}

}  // namespace fusee::report
