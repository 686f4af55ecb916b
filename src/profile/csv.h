#pragma once
#include <string>
#include <string_view>

#include "fusee/profile/profile.h"

namespace fusee::profile {

/// Reads measured curves: a line `angle_rad,series_Nm,parallel_Nm`, then at least 8 rows of three numbers with rising angle. A byte order
/// mark, CR LF, blank lines and lines that begin with '#' are passed over. Nothing else is guessed at.
/// @throws core::InvalidInput "file:line:column: series_Nm" for a gap, a text, a NaN, an angle that does not rise, too few rows
void read_table(std::string_view csv, const std::string& file, TablePair& table);

}  // namespace fusee::profile
