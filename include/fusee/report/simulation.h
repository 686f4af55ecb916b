#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "fusee/pipeline/design_report.h"
#include "fusee/pipeline/simulation.h"
#include "fusee/report/headline.h"

/// A simulation as files for programs (JSON, CSV) and people (HTML, text) (docs/simulation.md).
namespace fusee::report {

using pipeline::BreakAwayRow, pipeline::DeflectionLoop, pipeline::EquilibriumRow, pipeline::kUnknown, pipeline::MeasuredRow,
    pipeline::PathPoint, pipeline::ReleasePath, pipeline::SimulatedDeadBand, pipeline::SimulatedLevel, pipeline::Simulation,
    pipeline::StretchSide, pipeline::unknown_level, pipeline::unknown_survey, pipeline::WrapSide, pipeline::refusals;

/// Says in sentences with figures where the linear, the exact and the measured dead-band differ, and what the measured rows show.
[[nodiscard]] std::vector<std::string> remarks(const Simulation& simulation);

/// tau_Nm,linear_rad,extreme_rad,protocol_rad,condition_6,joint_stiffness_Nm_per_rad,capstan_rad with 17 digits, one row a level; nan where
/// the springs do not reach.
[[nodiscard]] std::string dead_band_csv(const std::vector<SimulatedLevel>& levels);
/// part,angle_rad,tau_Nm,tension_N,stretch_*_m,give_*_rad,width_rad with 17 digits, one row a working position.
[[nodiscard]] std::string wrap_hysteresis_csv(const std::vector<WrapSide>& wraps);
/// Width of both springs' loops together at one load of the capstan [rad]; NaN where a cam does not work.
[[nodiscard]] double wrap_width(const Simulation& simulation, double tau);
/// Energy lost in the cables' loops and their share of the dead-band, in a sentence. @pre simulation.wraps not empty
[[nodiscard]] std::string wrap_remark(const Simulation& simulation);
/// The part of the capstan's travel that the cables' stretch takes, in a sentence. @pre simulation.stretches not empty
[[nodiscard]] std::string stretch_remark(const Simulation& simulation);
/// The keys of docs/simulation.md, in that order; a NaN is null.
[[nodiscard]] std::string simulation_json(const Simulation& simulation);
/// One page in one file that opens offline: its scripts inside, no request.
[[nodiscard]] std::string simulation_html(const Simulation& simulation);
/// The paper's comparison of arrangements: one row each, the unit at the end of the column's name.
[[nodiscard]] std::string relatives_csv(const std::vector<Simulation>& simulations);
/// Writes simulation.json, dead_band.csv, simulation.html and, if cables have loops, wrap_hysteresis.csv into `folder`, which is made if it
/// is missing. Each file is written whole or not at all; other files stay. @throws core::IoError
std::vector<pipeline::FileRow> write_simulation(const Simulation& simulation, const std::filesystem::path& folder);
/// The levels as a table for a terminal, with measured rows and remarks below.
[[nodiscard]] std::string simulation_text(const Simulation& simulation);
/// Stiffness range, torque range and dead-band of several joints as a table for a terminal.
[[nodiscard]] std::string survey_text(const std::vector<Simulation>& simulations);

}  // namespace fusee::report
