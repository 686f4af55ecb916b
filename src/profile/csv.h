#pragma once
#include <string>
#include <string_view>

#include "fusee/profile/profile.h"

namespace fusee::profile {

/// Reads measured curves: columns angle_rad, series_Nm and parallel_Nm in any order, at least 8 rows with rising angle (core::parse_csv).
/// @param torque greatest one of the law that they are for [Nm]; 0: not known
/// @throws core::InvalidInput, of several core::InvalidInputs: "file:line:column: series_Nm" for a gap, a text, a NaN, an angle that does
/// not rise, a number out of range (10^4 of either sign), too few rows, numbers that look like degrees or mNm
void read_table(std::string_view csv, const std::string& file, TablePair& table, const core::CsvMapping& mapping = {}, double torque = 0.0);

/// Reads the measured curve of a single spring: columns angle_rad and torque_Nm. @throws as read_table
void read_one_spring(std::string_view csv, const std::string& file, Rows& rows, const core::CsvMapping& mapping = {});

}  // namespace fusee::profile
