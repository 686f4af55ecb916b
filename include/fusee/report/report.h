#pragma once
#include <filesystem>
#include <string>

#include "fusee/pipeline/make.h"
#include "fusee/report/headline.h"
#include "fusee/report/rule_counts.h"

/// A design as files for programs (JSON, CSV) and people (HTML).
namespace fusee::report {

using pipeline::AsExported, pipeline::DesignReport, pipeline::ExportedSpring, pipeline::FileRow, pipeline::JointAsExported,
    pipeline::LawReport, pipeline::PartReport, pipeline::SmoothedTable, pipeline::TableRow, pipeline::verdict;

/// `rows` loads, evenly spaced: tau_Nm,theta_rad,f_se_Nm,f_pe_Nm,s_Nm_per_rad,p_Nm_per_rad,u_se_J,u_pe_J,t with 17 digits (docs/report.md).
/// @throws core::InvalidInput if rows < 200; core::IoError
void write_springs_csv(const std::filesystem::path& path, const spring::SpringLaw& law, std::size_t rows);

/// A single spring: `rows` angles, evenly spaced: angle_rad,torque_Nm,stiffness_Nm_per_rad,energy_J. @param first_angle of the law [rad]
/// @throws core::IoError
void write_law_csv(const std::filesystem::path& path, const spring::SpringLaw& law, double first_angle, std::size_t rows);

/// The keys of docs/report.md, in that order; a NaN is null.
[[nodiscard]] std::string report_json(const DesignReport& design);

/// One page in one file that opens offline: no request. A design with an assembly carries the joint in 3D and its script (web/README.md).
[[nodiscard]] std::string report_html(const DesignReport& design);

/// Adds to the part files in `folder`: the simulation's files, springs.csv (of a single spring law.csv alone), report.json and
/// report.html. @throws core::IoError
void write_design(const pipeline::MadeDesign& made, const std::filesystem::path& folder);

}  // namespace fusee::report
