#pragma once
#include <string>
#include <string_view>

#include "fusee/profile/profile.h"

namespace fusee::profile {

/// Reads measured curves: columns angle_rad, series_Nm and parallel_Nm in any order and no other, at least 8 rows with rising angle
/// (core::parse_csv). Nothing is guessed.
/// @throws core::InvalidInput, of several core::InvalidInputs: "file:line:column: series_Nm" for a gap, a text, a NaN, an angle that does
/// not rise, a number out of range (10^4 of either sign), too few rows
void read_table(std::string_view csv, const std::string& file, TablePair& table);

}  // namespace fusee::profile
