#include "data/csv.h"

#include "fusee/report/simulation.h"

namespace fusee::report {

std::string dead_band_csv(const std::vector<SimulatedLevel>& levels) {
    std::string csv = "tau_Nm,linear_rad,extreme_rad,protocol_rad,condition_6,joint_stiffness_Nm_per_rad,capstan_rad\n";
    for (const SimulatedLevel& level : levels) {
        const SimulatedDeadBand& d = level.dead_band;
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
