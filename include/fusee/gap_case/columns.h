#pragma once
#include <string>
#include <vector>

#include "fusee/gap_case/case.h"
#include "fusee/gap_case/toml.h"

namespace fusee::gap_case {

/// The tables [columns.EXPERIMENT] of a case.toml, where a key names a column of the format: `q_rad = "pos"`, or
/// `q_rad = { column = "pos", unit = "deg", factor = -1 }`. Units: those of core/measure.h; also count
/// with counts_per_turn, and A with Nm_per_A, the torque at the capstan (or joint) of an ampere.
/// @throws core::InvalidInput "file:line:column: key" for an unknown column, unit or key, a factor of 0, a unit without its constant
[[nodiscard]] ColumnMaps read_columns(const CaseToml& toml);
/// One such key, "columns.motion.q_rad", of a column whose name has its unit: any unit of its quantity, or count or A as above.
/// @throws as read_columns
[[nodiscard]] ColumnMap read_column(const CaseToml& toml, const std::string& path, const std::string& column);
/// The names of all tables that read_columns may read: "columns", "columns.log", "columns.log.q_rad", ...
[[nodiscard]] std::vector<std::string> column_tables();

}  // namespace fusee::gap_case
